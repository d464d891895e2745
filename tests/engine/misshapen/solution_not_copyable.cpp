// error: a Solution must be default constructible, copyable and assignable
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Fixed : Value {
  Fixed() = default;
  Fixed(const Fixed&) = delete;
};
struct Problem {
  using Node = Value;
  using Solution = Fixed;
  Node root() const { return {}; }
  void expand(Node&& /*node*/, kusabi::engine::Expansion<Problem>& /*out*/) {}
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
