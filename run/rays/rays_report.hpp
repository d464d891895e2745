// Results of `kusabi rays`: table, JSON, CSV and graph. There may be millions of rays: they are
// kept as zero sets of 24 bytes, and the numbers of each are computed when it is written.
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
#include "run/output/terminal_page.hpp"
#include "run/rays/rays.hpp"
#include "run/wedged/whole_state_json.hpp"
#include "solvers/rays/maximal_cones.hpp"
#include "solvers/rays/reaction_cone.hpp"

namespace kusabi::run {

/// Maximum number of rays in the graph.
inline constexpr std::size_t max_drawn_rays = 200;

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

  /// Computes the numbers of all rays, and writes them to those of `table`, `csv` and `json` that
  /// are not null. `found` includes the numerical health of the numbers afterwards.
  /// @param head first members of the result file
  void write(nlohmann::ordered_json head, std::ostream* table, std::ostream* csv, JsonWriter* json);

  /// The head of a result in lines: all but the rays, with cones that do not name their rays.
  /// @param head its first members
  [[nodiscard]] std::string head_line(nlohmann::ordered_json head);

  /// Last lines of the table: cones, counts, numerical health, and the answer.
  [[nodiscard]] std::string summary() const;

  /// Graph of cones and their rays in the language of Graphviz; with too many rays only their
  /// number.
  void draw(std::ostream& out) const;

  [[nodiscard]] bool can_be_drawn() const { return found_.rays.size() <= max_drawn_rays; }

 private:
  [[nodiscard]] rays::Supports supports(std::size_t number) const {
    return {found_.rays[number], cone_.all()};
  }
  [[nodiscard]] std::string states(std::size_t number) const;
  [[nodiscard]] std::string cell_of_count(const rays::Cone& cone) const;
  [[nodiscard]] nlohmann::ordered_json tree_member() const;
  [[nodiscard]] nlohmann::ordered_json last_members();
  [[nodiscard]] nlohmann::ordered_json end_members() const;
  // Up to the list of rays, which stays open.
  void begin(JsonWriter& json, nlohmann::ordered_json head) const;
  void end_rays_and_all(JsonWriter& json);  // from the end of the list of rays
  [[nodiscard]] nlohmann::ordered_json ray_json(std::size_t number, const rays::Ray& ray) const;
  [[nodiscard]] nlohmann::ordered_json motion_json(std::size_t number);
  [[nodiscard]] nlohmann::ordered_json cone_json(const rays::Cone& cone) const;
  [[nodiscard]] nlohmann::ordered_json lean_cone(const rays::Cone& cone) const;
  [[nodiscard]] nlohmann::ordered_json cone_candidates(const rays::Cone& cone) const;
  void add_motions(nlohmann::ordered_json& json, const rays::Cone& cone) const;
  [[nodiscard]] std::string ray_lines(std::size_t number, const rays::Ray& ray) const;
  void begin(CsvWriter& csv) const;  // the header
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
