// error: a Solution needs `template <class Archive> void serialize(Archive& archive, unsigned
// version)`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

#include <vector>

#include <boost/serialization/vector.hpp>

struct Plain {
  int number = 0;
};
struct Problem : Right<Problem, Value, std::vector<Plain>> {};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
