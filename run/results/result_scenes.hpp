// What a result file has to draw.
#pragma once

#include <string>
#include <vector>

#include "pictures/svg/picture.hpp"
#include "pictures/svg/scene.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// Which scenes are made: each has the positions of all nodes, and there may be many thousands.
struct SceneChoice {
  std::size_t first = 0;  ///< from 0
  std::size_t most;       ///< so many from there on
};

struct ResultScenes {
  pictures::Picture picture;
  std::vector<pictures::Scene> scenes;  ///< those chosen, in the order of the answer
  std::vector<std::size_t> entries;     ///< of patterns and rays: which of the list each shows
  std::size_t count = 0;                ///< how many there are, chosen or not
  pictures::Scene structure;            ///< at rest, without an answer
  std::string things;                   ///< "patterns", "rays", "collapses"
};

/// There may be none. @throws WrongInput in one line, if it is no result that can be drawn
ResultScenes chosen_scenes(const ResultReader& reader, SceneChoice choice);

/// There is at least one to choose from.
/// @param file its name, for messages
/// @throws WrongInput in one line, if it is no such file or has nothing to draw
ResultScenes result_scenes(const ResultReader& reader, const std::string& file, SceneChoice choice);

}  // namespace kusabi::run
