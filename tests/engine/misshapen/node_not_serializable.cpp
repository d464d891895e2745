// error: a Node needs `template <class Archive> void serialize(Archive& archive, unsigned version)`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Plain {
  int number = 0;
};
struct Problem : Right<Problem, Plain> {};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
