// error: a problem needs `void expand(Node&& node, kusabi::engine::Expansion<P>& out)`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Other : Right<Other> {};
struct Problem : Right<Other> {};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
