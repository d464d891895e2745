// What a result comes to, in a sentence for a person who has not asked for it.
#pragma once

#include <string>
#include <vector>

#include "run/results/result_reader.hpp"

namespace kusabi::run {

struct Conclusion {
  std::string sentence;
  std::vector<std::string> reservations;  ///< what is open, or not proved
};

/// @throws WrongInput
Conclusion conclusion(const ResultReader& reader);

}  // namespace kusabi::run
