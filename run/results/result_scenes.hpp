// What a result file has to draw.
#pragma once

#include <string>
#include <vector>

#include "pictures/svg/picture.hpp"
#include "pictures/svg/scene.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

struct ResultScenes {
  pictures::Picture picture;
  std::vector<pictures::Scene> scenes;  ///< in the order of the answer
  std::vector<std::size_t> entries;     ///< of patterns and rays: which of the list each shows
  pictures::Scene structure;            ///< at rest, without an answer
  std::string things;                   ///< "patterns", "rays", "collapses"
};

/// There may be none. @throws WrongInput in one line, if it is no result that can be drawn
ResultScenes all_scenes(const ResultReader& reader);

/// At least one.
/// @param text of the file
/// @param file its name, for messages
/// @throws WrongInput in one line, if it is no such file or has nothing to draw
ResultScenes result_scenes(const std::string& text, const std::string& file);

}  // namespace kusabi::run
