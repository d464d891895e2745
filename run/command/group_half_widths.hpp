// `--group-alpha wind=20,snow=3`: half-widths of some uncertain loads.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace kusabi::run {

/// Names, which may have any character but a comma, each with its half-width; none of no text.
/// @throws WrongInput
std::vector<std::pair<std::string, double>> group_half_widths(const std::string& text);

}  // namespace kusabi::run
