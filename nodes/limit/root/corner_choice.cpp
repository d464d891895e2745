// Number of corners times the work of one.
#include "nodes/limit/root/corner_choice.hpp"

#include <cmath>

namespace kusabi::limit {
namespace {

/// Work of a corner besides its iterations: a factorisation, the check of the answer and the proof.
constexpr double work_per_program = 20;

}  // namespace

CornerChoice::CornerChoice(int loads, double first, double next)
    : loads_(loads), first_(first), next_(next) {}

double CornerChoice::work_for(int signs) const {
  return std::ldexp(next_ + work_per_program, signs);
}

bool CornerChoice::is_less_than_a_round() const {
  return loads_ == 0 || is_less_than(loads_ * first_);
}

int CornerChoice::signs_within(double work) const {
  int signs = 0;
  while (signs < loads_ && work_for(signs + 1) <= work) ++signs;
  return signs;
}

}  // namespace kusabi::limit
