// Scene of a body in space as data for the view that a reader turns (turning_script.hpp).
#pragma once

#include <string>

#include "pictures/svg/scene.hpp"

namespace kusabi::run {

/// JSON: positions as integers in ten-thousandths of half the size, faces, bars, supports, loads
/// and candidates; only nodes that are drawn. Empty if the scene is in the plane,
/// or has too many faces to be drawn at each step.
std::string turning_data(const pictures::Scene& scene);

/// The members of these data that differ from those of another scene of the same structure, as
/// JSON; null: only the other has it.
/// @param leading turning_data() of the other scene, not empty
std::string turning_difference(const pictures::Scene& scene, const std::string& leading);

}  // namespace kusabi::run
