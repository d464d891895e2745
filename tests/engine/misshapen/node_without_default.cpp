// error: a Node must be default constructible, copyable and assignable
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Numbered : Value {
  explicit Numbered(int given) : Value{given} {}
};
struct Problem {
  using Node = Numbered;
  using Solution = Value;
  Node root() const { return Node(1); }
  void expand(Node&& /*node*/, kusabi::engine::Expansion<Problem>& /*out*/) {}
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
