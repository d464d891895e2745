// error: emit must be `bool emit(const kusabi::engine::Path& path, Solution& solution)`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  bool emit(Solution& /*solution*/) { return true; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
