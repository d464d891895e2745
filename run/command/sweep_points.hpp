// Points of --mu and --alpha: a range or a list.
#pragma once

#include <string>
#include <vector>

namespace kusabi::run {

/// "0.1:1.0:0.05", from a number to another in steps, or "0.1,0.5,1". Points of a range are
/// decimals: 0.1 + 4 x 0.05 is 0.3.
/// @param option its name, for messages
/// @param zero true if a point may be zero; none may be negative
/// @return increasing
/// @throws WrongInput
std::vector<double> sweep_points(const std::string& option, const std::string& text, bool zero);

}  // namespace kusabi::run
