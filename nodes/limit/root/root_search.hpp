// Root of a worst-case limit load on all ranks: the same programs in the same units, with
// distributed pricing of cuts.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/limit/model/limit_parameters.hpp"
#include "nodes/limit/root/limit_answer.hpp"
#include "nodes/limit/root/worst_case.hpp"
#include "nodes/limit/splitting/column_blocks.hpp"
#include "problems/limit/limit_analysis.hpp"
#include "problems/limit/limit_problem.hpp"

namespace kusabi::limit {

class RootSearch {
 public:
  /// @pre both outlive this object. Every rank makes the same calls.
  /// @param split_from as in LimitParameters
  RootSearch(engine::Analysis& analysis, const problems::LimitProblem& problem,
             int split_from = default_split_from)
      : analysis_(analysis), problem_(problem), split_from_(split_from) {}

  /// Solves the nominal load in a model, which is used from then on.
  LoadStatus set_up(problems::LimitModel model);
  /// True if the result of the last set_up() was `collapses`, which the other functions require.
  [[nodiscard]] bool is_set_up() const { return solvers_ && solvers_->nominal.motion.size() > 0; }

  /// Uses units not far below the uncertain loads, if the simplex method succeeds with them. After a
  /// stop is_set_up() may be false.
  /// @param alpha in the unit of force
  void choose_units(double alpha);

  /// Splitting ends at a load with a factor below this, since only the upper bound matters then.
  void set_enough(double factor) { enough_ = factor; }

  /// The rounds in the present model. @param alpha scaled
  RootResult solve(double alpha, Corners corners);

  /// The same in units adjusted to the worst case found, since loads that are large relative to the
  /// nominal ones may cause another collapse. @param alpha in the unit of force
  RootResult solve_balanced(double alpha, Corners corners = Corners::never);

  /// True if solve() finds all cuts at once.
  [[nodiscard]] bool splits() const { return model().uncertain_count() >= split_from_; }

  /// True if the ranks have agreed to stop; all get the same answer.
  bool ended();

  [[nodiscard]] engine::Analysis& analysis() { return analysis_; }
  [[nodiscard]] const problems::LimitProblem& problem() const { return problem_; }
  [[nodiscard]] const problems::LimitModel& model() const { return solvers_->model; }
  [[nodiscard]] double scaled(double alpha) const { return alpha / model().force_unit; }
  [[nodiscard]] LoadFactor& load_factor() { return solvers_->load_factor; }
  /// @pre is_set_up()
  [[nodiscard]] const Collapse& nominal() const { return solvers_->nominal; }

  /// @param dead the load of the collapse, scaled
  [[nodiscard]] LimitCollapse in_units(const Collapse& collapse, const Eigen::VectorXd& dead);
  /// @param minimum the least factor of the load, scaled
  [[nodiscard]] LimitCollapse in_units(const Collapse& collapse,
                                       std::optional<double> minimum) const;

 private:
  /// A model and the solvers of its programs, constructed anew when the scaling changes.
  struct Solvers {
    problems::LimitModel model;
    LoadFactor load_factor;
    StaticPricing pricing;
    Collapse nominal;

    Solvers(problems::LimitModel of, const support::Stop& stop)
        : model(std::move(of)), load_factor(model, stop), pricing(model, stop) {}
  };

  support::Stop lockstep_stop();
  splitting::Sharing shared_columns();
  std::vector<StaticCut> price(const Eigen::VectorXd& z, std::span<const int> columns);
  void say(const std::string& what);
  void say_ends(std::uint64_t round, double lower, double upper);

  engine::Analysis& analysis_;
  const problems::LimitProblem& problem_;
  int split_from_;
  double enough_ = -linear::infinity;
  bool ended_ = false;    // all ranks have agreed to stop
  bool sharing_ = false;  // ranks do different work at present
  std::unique_ptr<Solvers> solvers_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace kusabi::limit
