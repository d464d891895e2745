// Test program whose search throws on the last rank, at its thousandth node; the other ranks have
// an endless tree. It hangs unless the exception ends all ranks.
#include <stdexcept>

#include "engine/search.hpp"
#include "engine/transport/mpi.hpp"

namespace {

class Endless {
 public:
  using Node = int;
  using Solution = int;
  explicit Endless(bool fails) : fails_(fails) {}
  Node root() const { return 0; }
  void expand(Node&& node, kusabi::engine::Expansion<Endless>& out) {
    if (++opened_ == 1000 && fails_) throw std::runtime_error("the thousandth node");
    // Wide trees on a long path would exceed the memory.
    for (int child = 0; child < (node < 1000 ? 2 : 1); ++child) out.branch(node + 1);
  }

 private:
  bool fails_;
  int opened_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const kusabi::engine::MpiEnvironment mpi(argc, argv);
  kusabi::engine::MpiTransport transport;
  Endless endless(transport.rank() == transport.size() - 1);
  kusabi::engine::search(endless, transport);
  return 0;
}
