// The bounds are found in the scaled model, and are put into units here.
#include "nodes/limit/safe_big_m.hpp"

#include <cstddef>

#include "nodes/limit/balanced_model.hpp"
#include "nodes/limit/motion_bounds.hpp"
#include "nodes/limit/root_search.hpp"
#include "problems/limit/mixed_limit.hpp"

namespace kusabi::limit {
namespace {

// What gamma_j = 1 takes from the load factor, m, by the program itself.
Eigen::VectorXd price_of_gamma(const problems::LimitModel& model, double alpha) {
  const int m = model.uncertain_count();
  const auto unlimited = [](int size) {
    return Eigen::VectorXd::Constant(size, linear::infinity).eval();
  };
  const auto mixed =
      problems::worst_case_program(model, alpha, Eigen::VectorXd::Ones(m),
                                   unlimited(model.free_count()), unlimited(model.member_count()));
  Eigen::VectorXd price(m);
  const int first = model.free_count() + model.member_count();
  for (int j = 0; j < m; ++j) {
    price(j) = -mixed.program.columns[static_cast<std::size_t>(first + j)].cost * model.factor_unit;
  }
  return price;
}

}  // namespace

std::optional<Eigen::VectorXd> safe_big_m(engine::Campaign& campaign,
                                          const problems::LimitProblem& problem, double alpha) {
  RootSearch search(campaign, problem);
  const bool collapses = search.set_up(problems::limit_model(problem)) == LoadStatus::collapses ||
                         search.set_up(balanced_model(problem, 0)) == LoadStatus::collapses;
  if (!collapses) return std::nullopt;
  search.settle_for(alpha);
  const auto root = search.solve_balanced(alpha);
  if (!root.worst) return std::nullopt;
  const auto& model = search.model();
  const auto bounds =
      motion_bounds(model, search.scaled(alpha), root.cuts, root.worst->collapse.factor);
  if (!bounds || !bounds->motion.allFinite()) return std::nullopt;
  // alpha w_j gamma_j is a share of the load factor, the same in either program.
  const Eigen::VectorXd unit =
      price_of_gamma(model, search.scaled(alpha))
          .cwiseQuotient(price_of_gamma(problems::unscaled_model(problem), alpha));
  return 2 * bounds->motion.cwiseProduct(unit);
}

}  // namespace kusabi::limit
