// error: a Solution needs `template <class Archive> void serialize(Archive& archive, unsigned
// version)`, or what Boost.Serialization has for its type must be included
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

#include <deque>

struct Problem : Right<Problem, Value, std::deque<int>> {};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
