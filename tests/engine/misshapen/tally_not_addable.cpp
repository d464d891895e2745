// error: a Tally needs `Tally& operator+=(const Tally& other)` to be summed up
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  using Tally = Value;
  Tally tally() const { return {}; }
};

void look(kusabi::engine::Outcome<Problem>& outcome) {
  outcome.tally();
}
