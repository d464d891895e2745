// Scenes (pictures) of a result file.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pictures/svg/picture.hpp"
#include "pictures/svg/scene.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// Range of scenes to make: each contains the positions of all nodes, and there may be thousands.
struct SceneChoice {
  std::size_t first = 0;  ///< index, from 0
  std::size_t maximum;    ///< maximum number of scenes
  /// Of patterns and rays: indices in the list, ascending. Empty: by `first` and `maximum`.
  std::vector<std::size_t> entries{};
};

struct ResultScenes {
  pictures::Picture picture;
  std::vector<pictures::Scene> scenes;  ///< those chosen, in the order of the answer
  std::vector<std::size_t> entries;     ///< of patterns and rays: index in the list
  std::size_t count = 0;                ///< number of all scenes
  pictures::Scene structure;            ///< undeformed, without an answer
  std::string things;                   ///< "patterns", "rays", "collapses", "states"
};

/// Entries of a result of `hold` with a known state, each with `pattern` and `state`: that of the
/// holding friction coefficient, or one at an end of each interval of factors. @throws WrongInput
std::vector<const ResultJson*> held_states(const ResultReader& reader);

/// The ends of an interval of factors that `hold` has found, which are held; null: there is no end.
/// @throws WrongInput
std::pair<const ResultJson*, const ResultJson*> held_ends(const ResultReader& reader,
                                                          const ResultJson& interval);

/// The same as numbers, infinite without an end, as of an entry that is no interval.
std::pair<double, double> held_range(const ResultReader& reader, const ResultJson& entry);

/// Friction coefficient of the call of `hold`; nothing if the smallest one was requested.
std::optional<double> given_friction(const ResultReader& reader);

/// "under the dead load", "at factor 1.4": the load of a state.
/// @param factor of the reference load @param low, high the factors that are held, within which it
/// is rounded
std::string under_factor(double factor, double low, double high);

/// The motions by which statics alone excludes loads, of a result of `hold`. @throws WrongInput
std::vector<pictures::Scene> exclusion_scenes(const ResultReader& reader);

/// The list of scenes may be empty.
/// @throws WrongInput in one line if it is not a result that can be drawn
ResultScenes chosen_scenes(const ResultReader& reader, SceneChoice choice);

/// At least one scene; after the states of `hold`, the motions by which statics excludes loads.
/// @param file its name, for messages
/// @throws WrongInput in one line if it is not a result file or contains nothing to draw
ResultScenes result_scenes(const ResultReader& reader, const std::string& file, SceneChoice choice);

}  // namespace kusabi::run
