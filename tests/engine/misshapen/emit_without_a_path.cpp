// error: emit must be `void emit(const kusabi::engine::Path& path, Solution&& solution)`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  void emit(Solution&& /*solution*/) {}
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
