// compiles
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

#include <vector>

#include <boost/serialization/vector.hpp>

// A free function for the node, a member function for the solution.
struct Number {
  int number = 0;
};
template <class Archive>
void serialize(Archive& archive, Number& number, unsigned /*version*/) {
  archive& number.number;
}

// A private member with Boost as a friend.
class Counts {
 public:
  int count = 0;

 private:
  friend class boost::serialization::access;
  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& count;
  }
};

struct Problem final : Right<Problem, std::vector<Value>, Number> {
  using Tally = Counts;
  double objective(const Solution& /*solution*/) const { return 0; }
  float bound(const Node& /*node*/) const { return 0; }
  Tally tally() const { return {}; }
  double seconds() const { return 1; }
  double least_seconds() const { return 1; }
  static constexpr double work_of_first_child = 0.5;
};

void look(const Problem& problem) {
  kusabi::engine::simulate(problem, 2, 1);
}

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
