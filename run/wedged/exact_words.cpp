// The sentence and the JSON.
#include "run/wedged/exact_words.hpp"

#include <fmt/format.h>

#include "run/output/values.hpp"

namespace kusabi::run {

std::string exact_doubt(const wedged::ExactTest& test) {
  if (!test.unable.empty()) {
    return fmt::format(
        "numerically undecided: the scales of the structure are {:.1e} apart, where floating point "
        "may miss a pattern or add one, and {}",
        test.scale_ratio, test.unable);
  }
  return fmt::format(
      "proved but for {} with a margin of zero, of which no exact test says anything",
      counted(test.ties, "node"));
}

nlohmann::ordered_json exact_json(const wedged::ExactTest& test) {
  nlohmann::ordered_json json{{"scale_ratio", test.scale_ratio},
                              {"done", test.done},
                              {"refused", test.refused},
                              {"doubted", test.doubted},
                              {"ties", test.ties}};
  if (test.leaves_doubt()) json["doubt"] = exact_doubt(test);
  return json;
}

}  // namespace kusabi::run
