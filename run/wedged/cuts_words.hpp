// Words of the option --cuts.
#pragma once

#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "run/command/option_words.hpp"

namespace kusabi::run {

inline const OptionWords<wedged::Tightening>& cuts_words() {
  static const OptionWords<wedged::Tightening> words{{"auto", wedged::Tightening::automatic},
                                                     {"none", wedged::Tightening::never},
                                                     {"always", wedged::Tightening::always}};
  return words;
}

}  // namespace kusabi::run
