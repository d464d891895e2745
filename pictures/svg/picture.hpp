// Picture: one scene, or a sheet of many small scenes, with a title and a legend.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "pictures/svg/scene.hpp"

namespace kusabi::pictures {

/// Maximum number of scenes on a sheet.
inline constexpr std::size_t max_per_sheet = 60;

struct Picture {
  std::string title;
  std::vector<std::string> lines;  ///< below the title
  UnitNames units;
};

/// Draws a scene in all detail; its name follows the title, its lines follow those of the picture.
void write_svg(std::ostream& out, const Picture& picture, const Scene& scene);

/// Draws the first scenes, up to `max_per_sheet`, small, each with its name and its note.
/// @pre at least one
void write_sheet(std::ostream& out, const Picture& picture, const std::vector<Scene>& scenes);

}  // namespace kusabi::pictures
