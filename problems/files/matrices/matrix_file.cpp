// File names and their extensions.
#include "problems/files/matrices/matrix_file.hpp"

#include <filesystem>

namespace kusabi::problems {

TomlText matrix_file_name(const TomlReader& reader, const toml::node& entry) {
  const auto value = entry.is_string() ? entry.value<std::string>() : std::nullopt;
  TomlText name{value.value_or(""), reader.position(entry)};
  if (!name.text.ends_with(".mtx") && !name.text.ends_with(".sti")) {
    reader.fail(entry,
                "file is not the name of a matrix; expected file = \"....mtx\" (Matrix Market, or "
                "a substructure of CalculiX) or \"....sti\" (CalculiX, with the .dof beside it)");
  }
  return name;
}

std::string rows_file_of(const std::string& place) {
  if (!place.ends_with(".sti")) return {};
  return std::filesystem::path(place).replace_extension(".dof").string();
}

}  // namespace kusabi::problems
