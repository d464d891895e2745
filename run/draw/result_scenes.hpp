// What a result file has to draw.
#pragma once

#include <string>
#include <vector>

#include "pictures/svg/picture.hpp"
#include "pictures/svg/scene.hpp"

namespace kusabi::run {

struct ResultScenes {
  pictures::Picture picture;
  std::vector<pictures::Scene> scenes;  ///< at least one, in the order of the answer
  std::string things;                   ///< "patterns", "rays", "collapses"
};

/// @param text of the file
/// @param file its name, for messages
/// @throws WrongInput in one line, if it is no such file or has nothing to draw
ResultScenes result_scenes(const std::string& text, const std::string& file);

}  // namespace kusabi::run
