// The names of the files that a [[stiffness]] has.
#pragma once

#include <string>

#include "problems/files/toml/toml_reader.hpp"

namespace kusabi::problems {

/// The value of `file` of a [[stiffness]]: a name that ends in .mtx or .sti.
/// @throws InputError if it is none
TomlText matrix_file_name(const TomlReader& reader, const toml::node& entry);

/// The .dof file beside a .sti file, which says what its rows are; empty for others.
std::string rows_file_of(const std::string& place);

}  // namespace kusabi::problems
