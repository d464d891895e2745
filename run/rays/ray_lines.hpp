// Rays in JSON, and RayLines: the list of `kusabi rays --format jsonl`, one line per ray. Each rank
// writes its rays during the search to a part of its own; at the end rank 0 sorts the lines of all
// parts into the file. The file does not depend on the number of ranks.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "nodes/wedged/rays/ray_search.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/evidence/part_files.hpp"
#include "run/output/line_sorter.hpp"
#include "run/session/session.hpp"
#include "solvers/rays/maximal_cones.hpp"
#include "solvers/rays/reaction_cone.hpp"
#include "solvers/rays/zero_set.hpp"

namespace kusabi::run {

/// State of a candidate at a ray.
struct RayState {
  char letter;       ///< in tables
  const char* word;  ///< in JSON
};

class RayLines {
 public:
  /// Opens a part on every rank, unless an earlier run has finished. Session and cone must outlive
  /// it.
  /// @param goes_on as PartFiles()
  RayLines(Session& session, const rays::ReactionCone& cone, const PartsOwner& owner, bool goes_on,
           bool finished);

  /// Writes a ray to the part of this rank.
  void add(const rays::ZeroSet& zero, const rays::Ray& ray);

  /// Closes the parts; collective over all ranks. On rank 0 reads the lines of all parts and those
  /// of the rays among the findings, whose numerical health includes their numbers afterwards.
  /// @return the cones of all rays, on rank 0
  /// @throws std::runtime_error if a part is missing or incomplete
  rays::ConesOfRays close(wedged::RayFindings& findings);

  /// Writes the head line and all rays in the order of a result file. On rank 0, once.
  /// @param head without rays
  /// @return false if the file of an earlier run has this head: it stays as it is
  bool write(std::ostream& out, const std::string& head);

  /// Checks the parts for a run that resumes, or removes them. On rank 0, after write().
  void end(bool goes_on);

 private:
  [[nodiscard]] std::string line_of(const rays::ZeroSet& zero, const rays::Ray& ray) const;
  [[nodiscard]] rays::ConesOfRays cones_of_earlier() const;

  const rays::ReactionCone& cone_;
  PartsOwner owner_;
  bool is_first_;
  std::optional<PartFiles> parts_;
  std::optional<LineSorter> sorter_;  // on rank 0, unless the file of an earlier run has the list
};

RayState state_of(const rays::Supports& supports, int candidate);

/// The keys `state` and `reaction`.
nlohmann::ordered_json lean_ray(const rays::Supports& supports, const rays::Ray& ray);

/// The cone of a ray from its key `state`.
rays::Cone cone_from_states(const nlohmann::ordered_json& states);

}  // namespace kusabi::run
