// error: a problem needs `void expand(Node&& node, kusabi::engine::Expansion<P>& out)`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  void expand(Node& /*node*/, kusabi::engine::Expansion<Problem>& /*out*/) {}
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
