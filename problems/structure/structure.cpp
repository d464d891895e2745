// Errors that know where in its file a structure's entry stands.
#include "problems/structure/structure.hpp"

#include <cstddef>

namespace kusabi::problems {

std::string_view axis_name(int axis) {
  return std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1);
}

support::InputError structure_error(const Structure& structure, support::SourcePosition position,
                                    std::string_view message) {
  const std::string& file =
      structure.sources.file.empty() ? structure.name : structure.sources.file;
  return support::InputError(file, position, message);
}

support::SourcePosition position_of(const std::vector<support::SourcePosition>& positions,
                                    int index) {
  const auto place = static_cast<std::size_t>(index);
  return place < positions.size() ? positions[place] : support::SourcePosition{};
}

}  // namespace kusabi::problems
