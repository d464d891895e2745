// L-BFGS with a diagonal of estimated second derivatives, renewed in each round.
#include "nodes/wedged/quadratic/quadratic_optimiser.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "nodes/wedged/quadratic/quadratic_proof.hpp"
#include "nodes/wedged/quadratic/reduced_form.hpp"
#include "nodes/wedged/quadratic/whole_form.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"

namespace kusabi::wedged {
namespace {

/// Weight of the first round, at least and by candidate, and its growth. With weight w the form is
/// singular at a coefficient larger by the share 1/w; slow growth allows long steps.
constexpr double min_first_weight = 100;
constexpr double first_weight_per_candidate = 0.5;
constexpr double growth = 1.5;
constexpr int steps_per_round = 100;
/// |S_jk| is smooth below this number divided by the weight: a kink at zero would shorten steps.
constexpr double roundness = 0.1;
/// Rounds end when one improves the coefficient by less than this share.
constexpr double min_round_gain = 1.5e-3;

/// Steps of the memory.
constexpr std::size_t remembered = 30;
/// Armijo's rule, and the least curvature of a pair that is remembered, over |y|^2.
constexpr double enough_decrease = 1e-4;
constexpr double min_curvature_of_pair = 1e-15;
constexpr int max_halvings = 25;

/// Factor of the roots of N, and how often it is applied, if the first form is not definite.
constexpr double reduction = 0.3;
constexpr int max_reductions = 4;

/// Logarithms of s for S = F_nt, where s only lowers the coefficient: as small as the least
/// eigenvalue of F_nn requires and the proof permits.
constexpr std::array log_squares_of_spectral_form{-14.0, -11.0, -8.0};
/// With more candidates no thresholds are tried: 35 of them take half a minute.
constexpr Eigen::Index max_candidates_for_thresholds = 600;

/// Root of P_ij at the start.
constexpr double first_root = 0.02;
/// Share of the largest coefficient of the first multipliers at which the search starts.
constexpr double inside = 0.9;
/// Shares of that coefficient that are tried for the proof, which needs a margin for rounding. The
/// exact one needs more where springs hold a body.
constexpr std::array room_for_proof{1 - 1e-6, 1 - 1e-4, 1 - 1e-2};
constexpr std::array room_with_motions{1 - 5e-3, 1 - 2e-2, 1 - 1e-1};

// Past steps and changes of the derivatives.
class Memory {
 public:
  void forget() { pairs_.clear(); }
  [[nodiscard]] bool is_empty() const { return pairs_.empty(); }

  void add(Eigen::VectorXd step, Eigen::VectorXd change) {
    const double product = step.dot(change);
    if (!(product > min_curvature_of_pair * change.squaredNorm())) return;
    pairs_.push_back({std::move(step), std::move(change), product});
    if (pairs_.size() > remembered) pairs_.pop_front();
  }

  // The two-loop recursion (Nocedal 1980).
  [[nodiscard]] Eigen::VectorXd direction(const Eigen::VectorXd& slopes,
                                          const Eigen::VectorXd& scales) const {
    Eigen::VectorXd q = slopes;
    std::vector<double> shares(pairs_.size());
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      shares[k] = pairs_[k].step.dot(q) / pairs_[k].product;
      q -= shares[k] * pairs_[k].change;
    }
    q = q.cwiseProduct(scales).eval();
    if (!is_empty()) {
      const auto& last = pairs_.back();
      q *= last.product / last.change.cwiseAbs2().dot(scales);
    }
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      q += (shares[k] - pairs_[k].change.dot(q) / pairs_[k].product) * pairs_[k].step;
    return q;
  }

 private:
  struct Pair {
    Eigen::VectorXd step, change;
    double product;
  };
  std::deque<Pair> pairs_;
};

class Optimiser {
 public:
  Optimiser(QuadraticForm& form, support::Stop stop)
      : form_(form),
        stop_(std::move(stop)),
        point_(form.first_point()),
        slopes_(point_),
        scales_(point_) {}

  // Sets the best of the first multipliers, P = -I. @return their coefficient
  double start();
  // Makes P_ij positive. @param best coefficient of the first multipliers
  void leave_diagonal(double best);
  void round(double weight);

  [[nodiscard]] bool ended() const { return support::is_requested(stop_); }
  [[nodiscard]] int evaluations() const { return evaluations_; }
  /// 0 if it is not above a given one.
  [[nodiscard]] double factor(double above = 0) {
    form_.set(point_, 0);
    return form_.largest_factor(above);
  }
  QuadraticPoint& point() { return point_; }

 private:
  double evaluate(QuadraticPoint& point, double weight) {
    ++evaluations_;
    form_.set(point, roundness / weight);
    return form_.potential(std::exp(point.log_factor()), weight);
  }
  bool step(double weight);
  // @return largest_factor(above)
  double clip(double threshold, double log_square, double above);

  QuadraticForm& form_;
  support::Stop stop_;
  QuadraticPoint point_, slopes_, scales_;
  Memory memory_;
  double value_ = 0;
  int evaluations_ = 0;
};

// Start: P = -I, and S is F_nt after soft thresholding; F_nt itself gives the spectral form.
double Optimiser::clip(double threshold, double log_square, double above) {
  const auto m = form_.candidates();
  Eigen::MatrixXd excess = Eigen::MatrixXd::Zero(m, m);
  for (Eigen::Index k = 1; k <= form_.tangents(); ++k)
    excess += form_.rows().middleCols(k * m, m).cwiseAbs2();
  excess = excess.unaryExpr([threshold](double square) {
    return square > threshold * threshold ? 1 - threshold / std::sqrt(square) : 0.0;
  });
  for (Eigen::Index k = 0; k < form_.tangents(); ++k)
    point_.slips().middleCols(k * m, m) =
        form_.rows().middleCols((k + 1) * m, m).cwiseProduct(excess);
  point_.log_squares().setConstant(log_square);
  return factor(above);
}

double Optimiser::start() {
  const auto m = form_.candidates();
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(m, m);
  for (Eigen::Index k = 1; k <= form_.tangents(); ++k)
    squares += form_.rows().middleCols(k * m, m).cwiseAbs2();
  std::vector<double> sizes(squares.data(), squares.data() + squares.size());
  std::ranges::sort(sizes);
  double best = 0;
  std::pair<double, double> chosen{0, 0};
  const auto try_one = [&](double threshold, double log_square) {
    const double own = clip(threshold, log_square, best);
    if (!(own > best)) return;
    best = own;
    chosen = {threshold, log_square};
  };
  const auto try_all = [&] {
    for (const double log_square : log_squares_of_spectral_form) try_one(0, log_square);
    if (m > max_candidates_for_thresholds && best > 0) return;
    for (const double quantile : {0.01, 0.03, 0.1, 0.3, 0.6, 0.9, 0.97})
      for (const double log_square : {-5.0, -4.0, -3.0, -2.0, -1.0}) {
        if (ended() && best > 0) return;
        const auto place =
            static_cast<std::size_t>(quantile * static_cast<double>(sizes.size() - 1));
        try_one(std::sqrt(sizes[place]), log_square);
      }
  };
  try_all();
  for (int k = 0; k < max_reductions && !(best > 0) && point_.has_pairs(); ++k) {
    point_.pair_roots() *= reduction;
    try_all();
  }
  clip(chosen.first, chosen.second, 0);
  return best;
}

// Roots of zero would stay there.
void Optimiser::leave_diagonal(double best) {
  for (double root = first_root; root > first_root / 100; root /= 2) {
    point_.roots().setConstant(root);
    point_.roots().diagonal().setZero();
    if (factor() > best / 2) break;
  }
  point_.log_factor() = std::log(inside * factor());
}

bool Optimiser::step(double weight) {
  auto way = memory_.direction(slopes_.values, scales_.values);
  double descent = slopes_.values.dot(way);
  if (!(descent > 0)) {
    memory_.forget();
    way = slopes_.values.cwiseProduct(scales_.values);
    descent = slopes_.values.dot(way);
  }
  double length = memory_.is_empty() ? std::min(1.0, 1 / std::sqrt(descent)) : 1.0;
  auto next = point_;
  for (int halving = 0; halving < max_halvings; ++halving, length /= 2) {
    next.values = point_.values - length * way;
    const double value = evaluate(next, weight);
    if (!(value <= value_ - enough_decrease * length * descent)) continue;
    const Eigen::VectorXd before = slopes_.values;
    form_.derivatives(next, weight, slopes_);
    memory_.add(next.values - point_.values, slopes_.values - before);
    point_ = std::move(next);
    value_ = value;
    return true;
  }
  const bool again = !memory_.is_empty();
  memory_.forget();
  return again;
}

void Optimiser::round(double weight) {
  memory_.forget();
  value_ = evaluate(point_, weight);
  if (!std::isfinite(value_)) return;
  form_.scales(point_, weight, scales_);
  form_.derivatives(point_, weight, slopes_);
  for (int k = 0; k < steps_per_round && !ended(); ++k)
    if (!step(weight)) return;
}

// Null: a motion lifts the body off all candidates.
std::unique_ptr<QuadraticForm> form_of(const problems::WedgedProblem& block) {
  if (block.modes.matrix.cols() == 0) return std::make_unique<ReducedForm>(block);
  auto motions = form_motions(block);
  auto pairs = opposite_pairs(motions.lifting);
  if (pairs.rows() == 0) return nullptr;
  return std::make_unique<WholeForm>(block, std::move(motions), std::move(pairs));
}

}  // namespace

QuadraticBound quadratic_bound(const problems::WedgedProblem& block,
                               const QuadraticParameters& parameters) {
  QuadraticBound bound;
  const auto form = form_of(block);
  if (!form) return bound;
  Optimiser optimiser(*form, parameters.stop);
  double best = optimiser.start();
  if (parameters.rounds > 0) optimiser.leave_diagonal(std::exchange(best, 0));
  double weight = std::max(min_first_weight,
                           first_weight_per_candidate * static_cast<double>(form->candidates()));
  for (int round = 0; round < parameters.rounds && !optimiser.ended(); ++round, weight *= growth) {
    optimiser.round(weight);
    const double reached = optimiser.factor();
    const bool worth = reached > best * (1 + min_round_gain);
    best = std::max(best, reached);
    if (!worth || best >= parameters.maximum) break;
  }
  bound.evaluations = optimiser.evaluations();
  const double reached = optimiser.factor();
  for (const double room : block.modes.matrix.cols() > 0 ? room_with_motions : room_for_proof) {
    const double factor = std::min(room * reached, parameters.maximum);
    if (!(factor > parameters.enough)) break;
    const auto multipliers = form->multipliers(optimiser.point(), factor);
    auto friction = candidate_friction(block, factor);
    if (friction.empty()) friction.assign(block.contact_names.size(), factor);
    if (!form_proves_infeasible(block, friction, multipliers)) continue;
    bound.factor = factor;
    bound.numbers = multipliers.numbers();
    break;
  }
  return bound;
}

}  // namespace kusabi::wedged
