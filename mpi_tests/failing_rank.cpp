// A search that throws on the last rank, at the thousandth node that it opens; the others are left
// with an endless tree. Unless the failure ends all ranks, this hangs.
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
    // The children of a long path would fill the memory.
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
