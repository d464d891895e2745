// Allocation test: NodeSolver allocates nothing after its construction. Eigen's own check counts
// allocations; the sources are compiled into this test with the check enabled.
#include <gtest/gtest.h>

#include "solvers/conic/node_solver.hpp"
#include "tests/solvers/conic/contact_problem.hpp"

namespace kusabi::conic {
namespace {

// Forbids the allocation of Eigen storage during its lifetime.
class NoAllocation {
 public:
  NoAllocation() { Eigen::internal::set_is_malloc_allowed(false); }
  ~NoAllocation() { Eigen::internal::set_is_malloc_allowed(true); }
  NoAllocation(const NoAllocation&) = delete;
  NoAllocation& operator=(const NoAllocation&) = delete;
};

template <int D>
void solve_without_allocation(int m) {
  std::mt19937_64 generator(1);
  const testing::ContactProblem problem = testing::random_problem(D, m, 0.3, 1.5, generator);
  NodeSolver<D> solver(problem.compliance, problem.friction);
  const NoAllocation guard;
  const std::uint64_t first = 0b01, second = 0b10;
  for (const StopEarly stop : {StopEarly{}, StopEarly{false, false}})
    for (const testing::Masks& masks :
         {testing::Masks{0, 0}, testing::Masks{first, second}, testing::Masks{0, first}})
      EXPECT_GT(solver.solve(masks.first, masks.second, stop).iterations, 0);
}

TEST(NodeSolver, AllocatesNothingInThePlane) {
  for (const int m : {2, 10, 40, 64}) solve_without_allocation<2>(m);
}

TEST(NodeSolver, AllocatesNothingInSpace) {
  for (const int m : {2, 10, 40, 64}) solve_without_allocation<3>(m);
}

TEST(AllocationDeathTest, IsDetected) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(
      {
        const NoAllocation guard;
        const Eigen::VectorXd storage = Eigen::VectorXd::Zero(10);
        EXPECT_EQ(storage[0], 0);
      },
      "heap allocation");
}

}  // namespace
}  // namespace kusabi::conic
