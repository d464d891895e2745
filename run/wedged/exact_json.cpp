// Exact test in a result file, and in a verdict.
#include "run/wedged/exact_json.hpp"

namespace kusabi::run {

nlohmann::ordered_json exact_json(const wedged::ExactTest& test) {
  return {{"scale_ratio", test.scale_ratio},
          {"done", test.done},
          {"refused", test.refused},
          {"refused_needed", test.closed_unproved},
          {"unproved", test.unproved}};
}

std::optional<answer::ExactRemainder> remainder_of(const wedged::ExactTest& test) {
  if (!test.is_open()) return std::nullopt;
  return answer::ExactRemainder{test.scale_ratio, test.unable,
                                test.closed_unproved + test.unproved};
}

}  // namespace kusabi::run
