// `--group-alpha wind=20,snow=3`: half-widths of groups of uncertain loads.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace kusabi::run {

/// Names, which may contain commas, with their half-widths; empty for an empty text.
/// @throws WrongInput
std::vector<std::pair<std::string, double>> group_half_widths(const std::string& text);

}  // namespace kusabi::run
