// error: a Node must be default constructible, copyable and assignable
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

#include <memory>

struct Unique : Value {
  std::unique_ptr<int> own;
};
struct Problem : Right<Problem, Unique> {};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
