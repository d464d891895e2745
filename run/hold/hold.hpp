// `kusabi hold FILE`: states of equilibrium under load. Without --mu the smallest friction
// coefficient at which the dead load can be held; with it the factors of the reference load that
// can be held in addition. Options, findings, verdict, tables, JSON and CSV.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "answer/verdict.hpp"
#include "engine/options.hpp"
#include "nodes/wedged/hold/diagram.hpp"
#include "nodes/wedged/hold/excluding_motion.hpp"
#include "nodes/wedged/hold/grip_search.hpp"
#include "nodes/wedged/hold/hold_search.hpp"
#include "nodes/wedged/hold/load_program.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"

namespace kusabi::run {

struct HoldOptions {
  ProblemInput input;
  std::vector<double> points;  ///< friction coefficients; none: the smallest one is requested
  std::string load_case;
  wedged::HoldParameters parameters;
  bool grip = false;                 ///< the grip range is requested
  bool diagram = false;              ///< pairs of factors of two load cases are requested
  std::vector<std::string> cases{};  ///< with `diagram`: names of both
  std::string certificate;           ///< file name; empty: none
  engine::Limits limits;
  CheckpointChoice checkpoint;
};

/// Factors that are held at one friction coefficient.
struct HeldPoint {
  double mu = 0;
  std::string load_case{};  ///< of several, the one whose states are shown
  wedged::HeldFactors factors{};
  std::optional<wedged::GripRange> grip{};

  [[nodiscard]] engine::Status status() const {
    return grip && grip->status != engine::Status::solved ? grip->status : factors.status;
  }
  [[nodiscard]] std::vector<wedged::HoldCost> costs() const {
    auto all = factors.costs;
    if (grip) all.insert(all.end(), grip->costs.begin(), grip->costs.end());
    return all;
  }
};

/// `friction` or `diagram` is present after the search, or there are points.
struct HoldFindings {
  std::string load_case{};   ///< empty: all loads of the file act
  bool of_reference = true;  ///< a reference load acts, in some load case
  std::optional<wedged::HoldingFriction> friction{};
  std::vector<HeldPoint>
      points{};            ///< of the options, in their order; of several, only complete ones
  bool certified = false;  ///< a certificate of factors was written
  bool enclosed = false;  ///< the stiffness matrix: otherwise nothing is recorded for a certificate
  std::optional<wedged::Diagram> diagram{};
  /// Motions by which statics alone excludes loads: at each end of the answer that has one.
  std::vector<wedged::ExcludingMotion> exclusions{};
  engine::Status ended = engine::Status::solved;  ///< of the points
  std::vector<wedged::HoldCost> costs_left{};     ///< of a point that is not complete

  /// Those of several load cases. The members above are then what all of them hold, with
  /// the state of the case `load_case`, and costs are those of the cases.
  std::vector<HoldFindings> cases{};
  /// Names of cases that decide the common answer; empty: none is known to.
  struct Decisive {
    std::string smallest{};  ///< bounds the factors from below
    std::string largest{};   ///< bounds them from above, or needs most friction
    std::string none{};      ///< holds nothing
  } decisive{};

  [[nodiscard]] engine::Status status() const {
    if (friction) return friction->status;
    if (diagram) return diagram->status;
    return ended;
  }
  [[nodiscard]] std::vector<wedged::HoldCost> costs() const {
    if (diagram) return diagram->costs;
    std::vector<wedged::HoldCost> all;
    for (const auto& each : cases) std::ranges::move(each.costs(), std::back_inserter(all));
    if (friction) std::ranges::copy(friction->costs, std::back_inserter(all));
    for (const auto& point : points) std::ranges::move(point.costs(), std::back_inserter(all));
    std::ranges::copy(costs_left, std::back_inserter(all));
    return all;
  }
};

/// Names of the candidates in contact, for tables.
std::string contact_of(const wedged::LoadedProblem& loaded, std::uint32_t block,
                       const std::optional<wedged::LoadedPattern>& pattern);
/// The same of a pattern of the whole problem.
std::string contact_of(const wedged::LoadedProblem& loaded, const wedged::LoadedPattern& pattern);
/// Names of the candidates in contact and of those separated. @param pattern of the whole problem
nlohmann::ordered_json pattern_names(const wedged::LoadedProblem& loaded,
                                     const wedged::LoadedPattern& pattern);

/// Answer for all load cases. Each was searched at the same coefficients; after an early end some
/// are missing.
/// @param cases those searched @param names of all  @param shown set to the index of the one whose
/// state is shown: that which needs most friction, or bounds the factors from above, else from below
HoldFindings held_in_all(std::vector<HoldFindings> cases, const std::vector<std::string>& names,
                         std::size_t& shown);

/// The answer without --mu.
answer::HoldingBracket bracket_of(const wedged::LoadedProblem& loaded,
                                  const HoldFindings& findings);
/// The answer at one of the coefficients, with its grip range if that is complete.
answer::HoldingFactors factors_of(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                                  const HoldFindings& findings, std::size_t point);

/// Bracket or intervals, and the costs of the searches.
std::string hold_table(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                       const HoldFindings& findings);

/// The member `result` of a result file.
nlohmann::ordered_json hold_json(const HoldOptions& options, const problems::Structure& structure,
                                 const wedged::LoadedProblem& loaded, const HoldFindings& findings);

/// Loads just beyond the ends of the answer for one friction coefficient, or of its smallest one;
/// none after an early end, and for several coefficients.
std::vector<wedged::ExcludedLoad> excluded_loads(const HoldOptions& options,
                                                 const wedged::LoadedProblem& loaded,
                                                 const HoldFindings& findings);

/// The costs of the searches: its member `statistics`.
nlohmann::ordered_json costs_json(const HoldFindings& findings);

answer::Verdict hold_verdict(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                             const HoldFindings& findings);

/// The pieces of the diagram.
nlohmann::ordered_json diagram_pieces(const wedged::LoadedProblem& loaded,
                                      const wedged::Diagram& diagram);

/// One row per piece, then one per vertex and direction.
/// @param cases names of both load cases
std::string diagram_table(const wedged::LoadedProblem& loaded,
                          const std::vector<std::string>& cases, const wedged::Diagram& diagram);

/// One row per vertex or direction of a piece, or per interval.
void write_held_csv(std::ostream& out, const HoldOptions& options,
                    const wedged::LoadedProblem& loaded, const HoldFindings& findings);

}  // namespace kusabi::run
