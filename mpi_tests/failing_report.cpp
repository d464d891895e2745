// Test program of one call (engine/run.hpp) whose report throws on rank 0. It hangs unless the
// exception ends all ranks, which wait for the exit code.
#include <stdexcept>

#include "engine/run.hpp"
#include "tests/engine/queens.hpp"

int main(int argc, char** argv) {
  kusabi::examples::Queens queens(6);
  return kusabi::engine::run(argc, argv, queens, [](const auto& /*outcome*/) {
    throw std::runtime_error("the placements cannot be written");
  });
}
