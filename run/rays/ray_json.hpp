// A ray as an entry of a list in JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "solvers/rays/maximal_cones.hpp"
#include "solvers/rays/reaction_cone.hpp"
#include "solvers/rays/zero_set.hpp"

namespace kusabi::run {

/// State of a candidate at a ray.
struct RayState {
  char letter;       ///< in tables
  const char* word;  ///< in JSON
};

RayState state_of(const rays::Supports& supports, int candidate);

/// The keys `state` and `reaction`.
nlohmann::ordered_json lean_ray(const rays::Supports& supports, const rays::Ray& ray);

/// The cone of a ray from its key `state`.
rays::Cone cone_from_states(const nlohmann::ordered_json& states);

}  // namespace kusabi::run
