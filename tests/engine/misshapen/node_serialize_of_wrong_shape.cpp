// error: a Node needs `template <class Archive> void serialize(Archive& archive, unsigned version)`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Unversioned {
  int number = 0;
  template <class Archive>
  void serialize(Archive& archive) {
    archive& number;
  }
};
struct Problem : Right<Problem, Unversioned> {};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
