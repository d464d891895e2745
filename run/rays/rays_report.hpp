// What `kusabi rays` says: the table for a person, the JSON and the CSV for programs, the graph.
//
// There may be millions of rays. They are kept as zero sets, 24 bytes each; their numbers are made
// one ray at a time, as it is written.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/rays/ray_search.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/output/csv.hpp"
#include "run/output/json_writer.hpp"
#include "run/output/page.hpp"
#include "run/rays/rays.hpp"
#include "run/wedged/whole_state_json.hpp"
#include "solvers/rays/maximal_cones.hpp"
#include "solvers/rays/reaction_cone.hpp"

namespace kusabi::run {

/// "double-description" or "tree".
std::string method_name(wedged::RayMethod method);

/// A graph of more is a black square.
inline constexpr std::size_t most_drawn_rays = 200;

class RaysReport {
 public:
  /// All must outlive it.
  RaysReport(const RaysOptions& options, const WholeStates& states, const rays::ReactionCone& cone,
             wedged::RayFindings& found, const wedged::ExactTest& exact, const Page& page)
      : options_(options),
        problem_(states.problem()),
        cone_(cone),
        found_(found),
        exact_(exact),
        page_(page),
        whole_(states) {}

  /// Makes the numbers of all rays, and writes to those of `table`, `csv` and `json` that are
  /// there. The health of the numbers is then part of `found`.
  void write(std::ostream* table, std::ostream* csv, JsonWriter* json);

  /// Cones and their rays, an edge for each that belongs to one, in the language of Graphviz; of
  /// too many rays how many there are, and nothing else.
  void draw(std::ostream& out) const;

  [[nodiscard]] bool can_be_drawn() const { return found_.rays.size() <= most_drawn_rays; }

 private:
  [[nodiscard]] rays::Supports supports(std::size_t number) const {
    return {found_.rays[number], cone_.all()};
  }
  [[nodiscard]] std::string states(std::size_t number) const;
  /// The last lines of the table: cones, counts, health, and the answer.
  [[nodiscard]] std::string summary() const;
  void begin(JsonWriter& json) const;       // up to the list of rays, which is open then
  void end_rays_and_all(JsonWriter& json);  // the rest
  [[nodiscard]] nlohmann::ordered_json ray_json(std::size_t number, const rays::Ray& ray) const;
  [[nodiscard]] nlohmann::ordered_json motion_json(std::size_t number);
  [[nodiscard]] nlohmann::ordered_json cone_json(const rays::Cone& cone) const;
  [[nodiscard]] std::string ray_lines(std::size_t number, const rays::Ray& ray) const;
  void begin(CsvWriter& csv) const;  // its header
  void add(CsvWriter& csv, std::size_t number, const rays::Ray& ray) const;

  const RaysOptions& options_;
  const problems::WedgedProblem& problem_;
  const rays::ReactionCone& cone_;
  wedged::RayFindings& found_;
  const wedged::ExactTest& exact_;
  Page page_;
  WholeStateJson whole_;
};

}  // namespace kusabi::run
