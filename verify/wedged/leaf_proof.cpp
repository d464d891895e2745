// Displacements by a regularised stiffness, corrected by the sliding modes, and the inequalities of
// the pattern with all errors.
#include "verify/wedged/leaf_proof.hpp"

#include <cmath>
#include <utility>

#include "verify/arithmetic/balance.hpp"

namespace kusabi::verify {
namespace {

/// Binary digits of the sum of the normal reactions, where it is requested.
constexpr int sum_digits = 30;

}  // namespace

LeafProof::LeafProof(const BlockModel& model, const support::IndexSet& contact,
                     std::span<const double> numbers, const std::optional<LoadShare>& share,
                     Grip* grip)
    : model_(model), block_(model.block()), contact_(contact), numbers_(numbers), grip_(grip) {
  if (share) add_load(*share);
}

// With v_n = -g on U and zero elsewhere, u = u' + v: u' satisfies the conditions without gaps on U
// under the load f - K v.
void LeafProof::add_load(LoadShare share) {
  const auto d = block_.dimension;
  auto load = model_.acting(share);
  gaps_ = std::move(load.gaps);
  std::vector<Dyadic> closing(d * model_.candidates());
  for (const int i : contact_) {
    const auto own = static_cast<std::size_t>(i);
    closing[d * own] = gaps_[own];
  }
  const DyadicList closed(closing);
  forces_ = std::move(load.forces);
  forces_ += block_.stiffness.middle * closed;
  force_error_ = load.error + block_.stiffness.radius * norm_above(closed);
  work_ = std::move(load.work);
}

std::optional<std::string> LeafProof::refusal() {
  const auto* stiffness = model_.regularised_at_normals(contact_);
  if (stiffness == nullptr) {
    auto [springs, sliding] = model_.grounding(contact_);
    sliding_ = std::move(sliding);
    stiffness = &model_.regularised(springs);
  }
  if (auto why = read_numbers()) return why;
  if (!stiffness->min_eigenvalue())
    return "K is not proved to be positive definite if its contacts are fixed along their normals";
  return stiffness->solve(unknowns_, right_, [&](const auto& u, const auto& r, const auto& off) {
    return check_feasible(*stiffness, u, r, off);
  });
}

std::optional<std::string> LeafProof::read_numbers() {
  const auto d = block_.dimension;
  const auto size = d * model_.candidates();
  std::vector<double> right(size, 0);
  std::vector<double> room(size, 0);
  auto number = numbers_.begin();
  for (std::size_t i = 0; i < model_.candidates(); ++i) {
    const bool contact = contains(contact_, i);
    for (std::size_t k = contact ? 1 : 0; k < d; ++k) {
      unknowns_.push_back(d * i + k);
      if (!contact) continue;
      if (block_.friction[i] == 0 && *number != 0) {
        return block_.names[i] + " has no friction, but a tangential reaction";
      }
      room[d * i + k] = block_.friction[i] == 0 ? 0 : 1;
      right[d * i + k] = *number++;
    }
  }
  right_ = DyadicList(right);
  if (model_.motions() > 0) mean_ = model_.own_coefficients(numbers_.last(model_.motions()));
  if (!sliding_.empty()) {
    if (auto why = balance_sliding(room)) return why;
  }
  tangential_ = right_;
  if (forces_.size() > 0) {
    right_ += forces_;
    right_error_ = right_error_ + force_error_;
  }
  return {};
}

std::optional<std::string> LeafProof::balance_sliding(const std::vector<double>& room) {
  constexpr auto not_balanced = "its tangential reactions are not in equilibrium";
  const auto size = room.size();
  // Modes that displace tangents of U. The other sliding modes must displace nothing on U.
  Elimination unseen(sliding_);
  std::vector<std::size_t> tangents;
  for (std::size_t row = 0; row < size; ++row) {
    if (room[row] != 0) tangents.push_back(row);
  }
  std::vector<std::size_t> chosen;
  model_.add_largest_rows(tangents, 0, unseen, chosen);
  for (const int i : contact_) {
    const auto normal = block_.dimension * static_cast<std::size_t>(i);
    if (unseen.add_equation(block_.motions.rows[normal])) return not_balanced;
  }
  for (const auto& motion : unseen.basis()) {  // no reaction of U does work on it
    if (!work_.empty() && sgn(dot(work_, motion)) != 0)
      return "its load does work on a rigid-body mode that no contact resists";
  }
  const auto& seen = unseen.removed();
  std::vector<Rationals> rows;
  Rationals forces;
  for (std::size_t row = 0; row < size; ++row) {
    auto& own = rows.emplace_back();
    for (const auto& motion : seen) own.push_back(dot(block_.motions.rows[row], motion));
    forces.emplace_back(right_[row].nearest() / block_.motions.lengths[row].nearest());
  }
  auto own_room = room;
  if (!work_.empty()) {  // the load is one more force, which is not changed
    auto& own = rows.emplace_back();
    for (const auto& motion : seen) own.push_back(dot(work_, motion));
    forces.emplace_back(1);
    own_room.push_back(0);
  }
  auto exact = balanced(rows, std::move(forces), own_room);
  if (!exact) return not_balanced;
  exact->resize(size);
  rows.resize(size);
  auto near = times_lengths(block_.motions, *exact);
  right_ = std::move(near.values);
  right_error_ = near.error * Dyadic(static_cast<double>(size));
  if (!add_corrections(rows, tangents, seen)) return not_balanced;
  return {};
}

bool LeafProof::add_corrections(const std::vector<Rationals>& rows,
                                const std::vector<std::size_t>& tangents,
                                const std::vector<Rationals>& modes) {
  const auto size = rows.size();
  const auto motions = modes.size();
  std::vector<Rationals> products(motions, Rationals(motions));
  for (const auto row : tangents) {
    for (std::size_t i = 0; i < motions; ++i) {
      for (std::size_t j = 0; j < motions; ++j) products[i][j] += rows[row][i] * rows[row][j];
    }
  }
  for (std::size_t motion = 0; motion < motions; ++motion) {
    lift_ = lift_ + normal_size(restricted_to_candidates(block_.motions, modes[motion]));
    Rationals unit(motions);
    unit[motion] = 1;
    const auto shares = solution(products, unit);
    if (!shares) return false;
    Rationals carrying(size);
    for (const auto row : tangents) carrying[row] = dot(rows[row], *shares);
    const auto correction = times_lengths(block_.motions, carrying);
    correction_ = correction_ + norm_above(correction.values) +
                  correction.error * Dyadic(static_cast<double>(size));
  }
  return true;
}

Dyadic LeafProof::normal_size(const ApproximateList& displacements) const {
  Dyadic sum;
  for (const int i : contact_) {
    const auto row = block_.dimension * static_cast<std::size_t>(i);
    sum = sum + absolute(displacements.values[row]) + displacements.error;
  }
  return sum;
}

std::optional<Dyadic> LeafProof::error_of_lift(const RegularisedStiffness& stiffness,
                                               const ApproximateList& shift,
                                               const Dyadic& pressures) const {
  const auto& s = *stiffness.min_eigenvalue();
  const auto change = (lift_ * correction_).scaled(1);
  if (!(s > change * stiffness.norm())) return {};
  const auto gap = stiffness.norm() * normal_size(shift).scaled(1);
  return gap + change * (pressures + quotient_above(stiffness.norm() * gap, s));
}

std::optional<std::string> LeafProof::check_feasible(const RegularisedStiffness& stiffness,
                                                     const DyadicList& u, const DyadicList& r,
                                                     const Dyadic& unknown) const {
  const auto d = block_.dimension;
  const auto& s = *stiffness.min_eigenvalue();
  Dyadic rest_squared;
  for (const auto row : unknowns_) {
    rest_squared = rest_squared + square(r[row] - right_[row]);
  }
  auto right_error = right_error_;
  auto rest = sqrt_above(rest_squared) + unknown + right_error;  // s times the error of u
  auto error = stiffness.norm() * rest + s * unknown;            // s times the error of K u
  auto reaction = r;                                             // K u minus the load
  if (forces_.size() > 0) {
    auto forces = forces_;
    for (auto& mantissa : forces.mantissas) mantissa = -mantissa;
    reaction += std::move(forces);
    error = error + s * force_error_;
  }
  auto moved = u;
  Dyadic off;
  if (!sliding_.empty()) {
    auto shift =
        restricted_to_candidates(block_.motions, model_.missing_motion(mean_, u, sliding_));
    const auto pressures = normal_size({reaction, quotient_above(error, s)});
    const auto lifted = error_of_lift(stiffness, shift, pressures);
    if (!lifted) return "its sliding modes displace the contacts along their normals by too much";
    right_error = right_error + *lifted;
    rest = rest + *lifted;
    error = error + stiffness.norm() * *lifted;
    off = s * shift.error;
    moved += std::move(shift.values);
  }
  Dyadic sum;  // s times the sum of the normal reactions, and its error
  Dyadic spread;
  for (std::size_t i = 0; i < model_.candidates(); ++i) {
    const auto& name = block_.names[i];
    if (!contains(contact_, i)) {
      const auto gap = gaps_.size() > 0 ? moved[d * i] + gaps_[i] : moved[d * i];
      if (!(s * gap > rest + off)) return name + " is not proved to separate";
      continue;
    }
    sum = sum + s * reaction[d * i];
    spread = spread + error;
    const auto pressure = s * reaction[d * i] - error;
    if (pressure.sign() <= 0) return name + " is not pressed against the obstacle";
    if (model_.friction()[i].sign() == 0) continue;  // r_t = 0 is required
    const auto shear = s * (sqrt_above(model_.tangential_square(tangential_, i)) + right_error);
    if (!(model_.friction()[i] * pressure > shear))
      return name + " slips, or is at the limit of friction";
  }
  if (grip_ != nullptr) {
    if (spread.scaled(sum_digits) > sum) return "the sum of its normal reactions is not known";
    *grip_ = {(sum - spread).rational() / s.rational(), (sum + spread).rational() / s.rational()};
  }
  return {};
}

}  // namespace kusabi::verify
