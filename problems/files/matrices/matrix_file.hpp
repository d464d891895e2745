// Names of the files of a [[stiffness]].
#pragma once

#include <string>

#include "problems/files/toml/toml_reader.hpp"

namespace kusabi::problems {

/// The value of `file` of a [[stiffness]]: a name that ends in .mtx or .sti.
/// @throws InputError for other names
TomlText matrix_file_name(const TomlReader& reader, const toml::node& entry);

/// The .dof file of a .sti file, which defines the rows; empty for other files.
std::string rows_file_of(const std::string& place);

}  // namespace kusabi::problems
