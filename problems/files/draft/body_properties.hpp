// Properties of a material that only loads need.
#pragma once

#include <utility>

#include "problems/files/toml/toml_reader.hpp"

namespace kusabi::problems {

/// The keys `density` and `expansion` of a material, zero if they are absent.
std::pair<double, double> body_properties(const TomlReader& reader, const TomlTable& group);

}  // namespace kusabi::problems
