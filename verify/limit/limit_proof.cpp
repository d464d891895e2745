// Lower and upper bound of a limit load factor in exact arithmetic.
#include "verify/limit/limit_proof.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "verify/limit/corrected_motion.hpp"

namespace kusabi::verify {
namespace {

Dyadic product(const Dyadic& a, double b) {
  return a * Dyadic(b);
}

}  // namespace

LimitColumn::LimitColumn(const Sparse& load) : direction(load) {
  if (load.size() != 1) return;
  weight = std::abs(load.front().second);
  direction.front().second = std::copysign(1.0, load.front().second);
}

LimitProof::LimitProof(const LimitTruss& truss, std::span<const LimitCut> cuts)
    : truss_(truss), cuts_(cuts), uncertain_(truss.uncertain.begin(), truss.uncertain.end()) {
  bool exact = true;
  for (const auto& column : truss.columns) {
    auto& rounded = columns_.emplace_back();
    auto& errors = column_errors_.emplace_back();
    for (const auto& [e, entry] : column) {
      rounded.emplace_back(e, entry.value.nearest());
      const auto error = absolute(entry.value - Dyadic(rounded.back().second)) + entry.error;
      if (error.sign() == 0) continue;
      errors.emplace_back(e, double_above(error));
      exact = false;
    }
  }
  if (exact) column_errors_.clear();
  const auto rounded = [](const Approximate& number) {
    return TwoDoubles::of(number.value, number.error);
  };
  std::vector<std::vector<std::pair<std::size_t, TwoDoubles>>> columns(truss_.columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (const auto& [e, entry] : truss_.columns[i]) columns[i].emplace_back(e, rounded(entry));
  }
  std::vector<TwoDoubles> reference;
  for (const auto& each : truss_.reference) reference.push_back(rounded({each, {}}));
  for (const auto& cut : cuts) {
    // d + k f_R - B y
    std::vector<EnclosedSum> sums(truss_.displacements());
    for (const auto& [e, value] : uncertain_[cut.column].direction) sums[e].add({value}, 1);
    for (std::size_t e = 0; e < sums.size(); ++e) sums[e].add(reference[e], cut.factor);
    for (const auto& [member, force] : cut.forces) {
      for (const auto& [e, entry] : columns[member]) sums[e].add(entry, -force);
    }
    defects_.push_back(defect_of(cut, sums));
  }
}

// Defect of a cut: by enclosed sums if none of them may be zero, otherwise exactly.
Sparse LimitProof::defect_of(const LimitCut& cut, std::span<const EnclosedSum> sums) const {
  Sparse sizes;
  for (std::size_t e = 0; e < sums.size(); ++e) {
    const auto size = sums[e].magnitude_above();
    if (!size) return exact_defect_of(cut);
    if (*size != 0) sizes.emplace_back(e, *size);
  }
  return sizes;
}

Sparse LimitProof::exact_defect_of(const LimitCut& cut) const {
  std::vector<Dyadic> load(truss_.displacements());
  for (const auto& [e, value] : uncertain_[cut.column].direction) {
    load[e] = load[e] + Dyadic(value);
  }
  Sparse sizes;
  const auto missing = defect(cut.forces, std::move(load), cut.factor);
  for (std::size_t e = 0; e < missing.size(); ++e) {
    if (missing[e].sign() != 0) sizes.emplace_back(e, double_above(missing[e]));
  }
  return sizes;
}

// |load + factor f_R - B forces|, by displacement, with the errors of B.
std::vector<Dyadic> LimitProof::defect(const Sparse& forces, std::vector<Dyadic> load,
                                       double factor) const {
  std::vector<Dyadic> errors(load.size());
  if (factor != 0) {
    for (std::size_t e = 0; e < load.size(); ++e) load[e].add_product(truss_.reference[e], factor);
  }
  for (const auto& [member, force] : forces) {
    if (force == 0) continue;
    for (const auto& [e, entry] : truss_.columns[member]) {
      load[e].add_product(entry.value, -force);
      errors[e].add_product(entry.error, std::abs(force));
    }
  }
  for (std::size_t e = 0; e < load.size(); ++e) load[e] = absolute(load[e]) + errors[e];
  return load;
}

bool LimitProof::is_admissible(const std::vector<double>& load) const {
  for (std::size_t j = 0; j < load.size(); ++j) {
    if (std::abs(load[j]) > truss_.alpha[j]) return false;
  }
  return true;
}

// Upper bound of the dissipation minus the work of the dead load on a motion.
Dyadic LimitProof::excess(const CollapseMotion& collapse, const std::vector<Dyadic>& u) const {
  Dyadic value;
  for (std::size_t e = 0; e < u.size(); ++e) value = value - truss_.dead[e] * u[e];
  for (std::size_t j = 0; j < collapse.load.size(); ++j) {
    for (const auto& [e, each] : truss_.uncertain[j])
      value.add_product(product(u[e], each), -collapse.load[j]);
  }
  const auto [tensions, compressions] = truss_.remaining(collapse.lost);
  for (std::size_t i = 0; i < truss_.members(); ++i) {
    const auto elongation = elongation_of(truss_.columns[i], u);
    value.add_product(absolute(elongation), elongation.sign() < 0 ? compressions[i] : tensions[i]);
    for (const auto& [e, entry] : truss_.columns[i])
      value.add_product(entry.error * absolute(u[e]), std::max(tensions[i], compressions[i]));
  }
  return value;
}

std::variant<mpq_class, std::string> LimitProof::upper(const CollapseMotion& collapse) const {
  if (!is_admissible(collapse.load)) return "the load is outside of its bounds";
  const auto u = corrected_motion(collapse, truss_, false);
  Dyadic work;  // of f_R
  for (std::size_t e = 0; e < u.size(); ++e) work = work + truss_.reference[e] * u[e];
  if (work.sign() <= 0) return "the reference load does no work on the motion";
  return mpq_class(excess(collapse, u).rational() / work.rational());
}

// The corrected motion is multiplied by the reference load at the displacement that is changed.
bool LimitProof::shows_no_factor(const CollapseMotion& collapse) const {
  const auto& reference = truss_.reference;
  const auto largest = std::ranges::max_element(reference, std::less<Dyadic>(), absolute);
  if (!is_admissible(collapse.load) || largest == reference.end() || largest->sign() == 0)
    return false;
  auto u = corrected_motion(collapse, truss_, true);
  Dyadic work;
  for (std::size_t e = 0; e < u.size(); ++e) {
    work = work + reference[e] * u[e];
    u[e] = u[e] * *largest;
  }
  auto& changed = u[static_cast<std::size_t>(largest - reference.begin())];
  changed = changed - work;
  if (excess(collapse, u).sign() < 0) return true;
  for (auto& each : u) each = Dyadic() - each;
  return excess(collapse, u).sign() < 0;
}

std::variant<mpq_class, std::string> LimitProof::lower(const LimitNode& node) const {
  const auto m = truss_.uncertain.size();
  Stress stress{node.forces, std::vector<Dyadic>(truss_.members()),
                std::vector<Dyadic>(truss_.displacements())};
  std::vector<Dyadic> share_of(m);
  Dyadic value(node.factor);
  for (const auto& [c, share] : node.shares) {
    const auto& cut = cuts_[c];
    const Dyadic mu(share);
    share_of[cut.column] = share_of[cut.column] + mu;
    value.add_product(mu, -std::abs(cut.factor));
    for (const auto& [i, force] : cut.forces) stress.taken[i].add_product(mu, std::abs(force));
    for (const auto& [e, missing] : defects_[c]) {
      if (!std::isfinite(missing)) return "the defect of a cut is too large to compute with";
      stress.defects[e].add_product(mu, missing);
    }
  }
  // f_D + sum over decided signs of s (alpha_j w + nu) d + lambda f_R - B q
  auto load = truss_.dead;
  for (std::size_t j = 0; j < m; ++j) {
    const auto& [weight, direction] = uncertain_[j];
    const Dyadic needed = Dyadic(truss_.alpha[j]) * Dyadic(weight);
    if (node.signs[j] == 0) {
      if (share_of[j] < needed) return "the cuts of a column have too small a share";
    } else {
      const Dyadic decided = needed + Dyadic(node.one_sided[j]);
      for (const auto& [e, each] : direction) {
        load[e].add_product(decided, node.signs[j] > 0 ? each : -each);
      }
    }
  }
  Sparse forces;
  for (std::size_t i = 0; i < node.forces.size(); ++i) forces.emplace_back(i, node.forces[i]);
  const auto own = defect(forces, std::move(load), node.factor);
  for (std::size_t e = 0; e < own.size(); ++e) stress.defects[e] = stress.defects[e] + own[e];
  return proved(value, stress, std::vector<bool>(truss_.members(), true));
}

std::variant<mpq_class, std::string> LimitProof::carried(const StressState& state) const {
  Stress stress{std::vector<double>(truss_.members()), std::vector<Dyadic>(truss_.members()),
                std::vector<Dyadic>(truss_.displacements())};
  std::vector<bool> stressed(truss_.members());
  for (const auto member : state.support) stressed[member] = true;
  Dyadic value;
  for (std::size_t k = 0; k < state.columns.size(); ++k) {
    const auto& [factor, forces] = state.columns[k];
    auto load = k == 0 ? truss_.dead : std::vector<Dyadic>(truss_.displacements());
    Sparse within;
    for (const auto& force : forces) {
      if (stressed[force.first]) within.push_back(force);
    }
    if (k == 0) {
      value = Dyadic(factor);
      for (const auto& [i, force] : within) stress.forces[i] = force;
    } else {
      value = value - absolute(Dyadic(factor));
      const Dyadic half_width(truss_.alpha[k - 1]);
      for (const auto& [e, each] : truss_.uncertain[k - 1]) load[e].add_product(half_width, each);
      for (const auto& [i, force] : within)
        stress.taken[i] = stress.taken[i] + absolute(Dyadic(force));
    }
    const auto own = defect(within, std::move(load), factor);
    for (std::size_t e = 0; e < own.size(); ++e) stress.defects[e] = stress.defects[e] + own[e];
  }
  return proved(value, stress, stressed);
}

// The factor, if the slack that members have beside their forces is enough for the forces against
// the defects; otherwise the reason why it is not.
// @param stressed members outside the support have no slack
std::variant<mpq_class, std::string> LimitProof::proved(const Dyadic& factor, const Stress& stress,
                                                        const std::vector<bool>& stressed) const {
  std::vector<double> slack;
  for (std::size_t i = 0; i < truss_.members(); ++i) {
    const Dyadic force(stress.forces[i]);
    const Dyadic tension = Dyadic(truss_.below.tension[i]) - force - stress.taken[i];
    const Dyadic compression = Dyadic(truss_.below.compression[i]) + force - stress.taken[i];
    const Dyadic& minimum = tension < compression ? tension : compression;
    if (minimum.sign() < 0) return "member " + truss_.names[i] + " yields";
    slack.push_back(stressed[i] ? double_below(minimum) : 0);
  }
  std::vector<double> defects;
  for (const auto& each : stress.defects) defects.push_back(double_above(each));
  if (are_covered(defects, slack)) return factor.rational();
  const MemberColumns members{truss_.displacements(), columns_, column_errors_};
  const auto found = forces_against_defects(members, slack, defects);
  if (const auto* const why = std::get_if<std::string>(&found)) return *why;
  const auto& against = std::get<std::vector<double>>(found);
  for (std::size_t i = 0; i < slack.size(); ++i) {
    if (!(against[i] <= slack[i]))
      return "member " + truss_.names[i] + " yields under the equilibrium defect";
  }
  return factor.rational();
}

// True if a multiple of the forces against unit defects is within the slack: these are the same for
// all nodes. Where a member has no slack they are not.
bool LimitProof::are_covered(const std::vector<double>& defects,
                             const std::vector<double>& slack) const {
  const double largest = defects.empty() ? 0 : std::ranges::max(defects);
  const auto is_zero = [](double each) { return each == 0; };
  if (largest == 0) return true;
  if (!std::isfinite(largest) || std::ranges::any_of(slack, is_zero)) return false;
  if (!unit_forces_)
    unit_forces_ = forces_against_unit_defects({truss_.displacements(), columns_, column_errors_});
  if (unit_forces_->empty()) return false;
  for (std::size_t i = 0; i < slack.size(); ++i) {
    // Rounded up.
    if (!((*unit_forces_)[i] * largest * (1 + 0x1p-50) <= slack[i])) return false;
  }
  return true;
}

}  // namespace kusabi::verify
