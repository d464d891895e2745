// Values of the option --cuts, and their names in results.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "nodes/wedged/relaxation/pattern_options.hpp"

namespace kusabi::run {

inline const std::vector<std::pair<std::string, wedged::Tightening>>& cuts_words() {
  static const std::vector<std::pair<std::string, wedged::Tightening>> words{
      {"auto", wedged::Tightening::automatic},
      {"none", wedged::Tightening::never},
      {"always", wedged::Tightening::always}};
  return words;
}

inline const std::string& name_of(wedged::Tightening tightening) {
  return std::ranges::find(cuts_words(), tightening,
                           &std::pair<std::string, wedged::Tightening>::second)
      ->first;
}

}  // namespace kusabi::run
