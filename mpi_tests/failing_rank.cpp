// A search that throws on whichever rank opens the thousandth node of its own; the others are left
// with an endless tree. Unless the failure ends all ranks, this hangs.
#include <stdexcept>

#include "engine/search.hpp"
#include "engine/transport/mpi.hpp"

namespace {

class Endless {
 public:
  using Node = int;
  using Solution = int;
  Node root() const { return 0; }
  void expand(Node&& node, kusabi::engine::Expansion<Endless>& out) {
    if (++opened_ == 1000) throw std::runtime_error("the thousandth node");
    out.branch(node + 1);
    out.branch(node + 1);
  }

 private:
  int opened_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const kusabi::engine::MpiEnvironment mpi(argc, argv);
  kusabi::engine::MpiTransport transport;
  Endless endless;
  kusabi::engine::search(endless, transport);
  return 0;
}
