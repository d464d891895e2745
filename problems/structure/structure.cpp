// Errors that know where in its file a structure's entry stands.
#include "problems/structure/structure.hpp"

#include <cstddef>

namespace kusabi::problems {

std::string_view axis_name(int axis) {
  return std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1);
}

InputError structure_error(const Structure& structure, SourcePosition position,
                           std::string_view message) {
  const std::string& file =
      structure.sources.file.empty() ? structure.name : structure.sources.file;
  return InputError(file, position, message);
}

SourcePosition position_of(const std::vector<SourcePosition>& positions, int index) {
  const auto place = static_cast<std::size_t>(index);
  return place < positions.size() ? positions[place] : SourcePosition{};
}

}  // namespace kusabi::problems
