// Bounds from the scaled model, converted to the units of the problem.
#include "nodes/limit/root/safe_big_m.hpp"

#include "nodes/limit/model/balanced_model.hpp"
#include "nodes/limit/root/motion_bounds.hpp"
#include "nodes/limit/root/root_search.hpp"

namespace kusabi::limit {
std::optional<Eigen::VectorXd> safe_big_m(engine::Analysis& analysis,
                                          const problems::LimitProblem& problem, double alpha) {
  RootSearch search(analysis, problem);
  const bool collapses = search.set_up(problems::limit_model(problem)) == LoadStatus::collapses ||
                         search.set_up(balanced_model(problem, 0)) == LoadStatus::collapses;
  if (!collapses) return std::nullopt;
  search.choose_units(alpha);
  if (!search.is_set_up()) return std::nullopt;
  const auto root = search.solve_balanced(alpha);
  if (!root.worst) return std::nullopt;
  const auto& model = search.model();
  const auto bounds =
      motion_bounds(model, search.scaled(alpha), root.cuts, root.worst->collapse.factor);
  if (!bounds || !bounds->motion.allFinite()) return std::nullopt;
  // Unit of d_j'u.
  const Eigen::VectorXd unit = model.factor_unit * model.direction_unit.cwiseInverse();
  return 2 * bounds->motion.cwiseProduct(unit);
}

}  // namespace kusabi::limit
