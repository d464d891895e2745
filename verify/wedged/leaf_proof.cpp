// Displacements by a regularised stiffness, with as many tangential reactions of U left to
// equilibrium as there are sliding modes, and the inequalities of the pattern with all errors.
//
// Recorded tangential reactions that are made orthogonal to the sliding modes in rational numbers,
// as for infeasible nodes, prove the same. But the modes of many bodies that touch have hundreds of
// digits then: an arch of 24 voussoirs took ten times as long.
#include "verify/wedged/leaf_proof.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/arithmetic/balance.hpp"

namespace kusabi::verify {
namespace {

/// Binary digits of the sum of the normal reactions, where it is requested.
constexpr int sum_digits = 30;

/// Binary digits of displacements that are sufficient to compute a motion, of the smallest of them:
/// far from the contacts those of a rotation are larger by the ratio of the levers.
constexpr int motion_digits = 20;

// True if two approximations, the earlier of which may be empty, agree.
bool has_settled(const DyadicList& earlier, const DyadicList& u) {
  if (earlier.size() == 0) return false;
  Dyadic change;
  std::optional<Dyadic> smallest;
  for (std::size_t row = 0; row < u.size(); ++row) {
    change = larger(change, absolute(u[row] - earlier[row]));
    if (u[row].sign() == 0) continue;
    const auto size = absolute(u[row]);
    if (!smallest || size < *smallest) smallest = size;
  }
  return !smallest || !(change.scaled(motion_digits) > *smallest);
}

}  // namespace

LeafProof::LeafProof(const BlockModel& model, const support::IndexSet& contact,
                     std::span<const double> numbers, const std::optional<LoadShare>& share,
                     Grip* grip)
    : model_(model),
      block_(model.block()),
      contact_(contact),
      numbers_(numbers),
      grip_(grip),
      held_(block_.dimension * model.candidates(), false),
      closing_(held_.size()),
      motion_{DyadicList(held_.size()), Dyadic()},
      load_forces_(held_.size()),
      gaps_(model.candidates()) {
  if (share) add_load(*share);
}

void LeafProof::add_load(LoadShare share) {
  auto load = model_.acting(share);
  gaps_ = std::move(load.gaps);
  std::vector<Dyadic> closing(held_.size());
  for (const int i : contact_) {
    const auto own = static_cast<std::size_t>(i);
    closing[block_.dimension * own] = Dyadic() - gaps_[own];
  }
  closing_ = DyadicList(closing);
  load_forces_ = std::move(load.forces);
  load_error_ = load.error;
  work_ = std::move(load.work);
}

std::optional<std::string> LeafProof::refusal() {
  const auto* stiffness = model_.regularised_at_normals(contact_);
  Grounding grounding;
  if (stiffness == nullptr) {
    grounding = model_.grounding(contact_);
    stiffness = &model_.regularised(grounding.springs);
    for (const auto row : grounding.held) held_[row] = true;
  }
  if (auto why = read_numbers()) return why;
  if (auto why = balance(grounding.unseen)) return why;
  if (!stiffness->min_eigenvalue())
    return "K is not proved to be positive definite if its contacts are fixed along their normals";
  if (!grounding.sliding.empty()) add_motion(*stiffness, grounding.sliding);
  close_gaps(*stiffness);
  return stiffness->solve(unknowns_, right_, [&](const auto& u, const auto& r, const auto& off) {
    return check_feasible(*stiffness, u, r, off);
  });
}

// Modes V that displace neither the normals of U nor T, exactly: reactions there do no work on them.
// The others are changed such that they, with the load, do none either. Then the reactions at S do
// no work, and vanish if V displaces S independently.
std::optional<std::string> LeafProof::balance(const std::vector<std::size_t>& unseen) {
  constexpr auto not_balanced = "its tangential reactions are not in equilibrium";
  if (unseen.empty()) return {};
  Elimination rest(model_.motions());
  for (const int i : contact_)
    rest.add_equation(block_.motions.rows[block_.dimension * static_cast<std::size_t>(i)]);
  for (std::size_t row = 0; row < held_.size(); ++row) {
    if (held_[row] && std::ranges::find(unseen, row) == unseen.end())
      rest.add_equation(block_.motions.rows[row]);
  }
  const auto modes = rest.basis();
  for (const auto row : unseen)
    if (!rest.add_equation(block_.motions.rows[row])) return not_balanced;
  std::vector<Rationals> rows;
  Rationals forces;
  std::vector<double> room;
  const auto add = [&](const Rationals& motions, double force, bool changes) {
    auto& own = rows.emplace_back();
    for (const auto& mode : modes) own.push_back(dot(motions, mode));
    forces.emplace_back(force);
    room.push_back(changes ? 1 : 0);
  };
  for (std::size_t row = 0; row < held_.size(); ++row) {
    const auto length = block_.motions.lengths[row].nearest();
    add(block_.motions.rows[row], tangential_[row].nearest() / length, has_given_reaction(row));
  }
  if (!work_.empty()) add(work_, 1, false);  // the load is not changed
  auto exact = balanced(rows, std::move(forces), room);
  if (!exact) return not_balanced;
  exact->resize(held_.size());
  auto near = times_lengths(block_.motions, *exact);
  tangential_ = std::move(near.values);
  tangential_error_ = near.error * Dyadic(static_cast<double>(held_.size()));
  return {};
}

bool LeafProof::has_given_reaction(std::size_t row) const {
  const auto own = row / block_.dimension;
  return row % block_.dimension != 0 && contains(contact_, own) && block_.friction[own] != 0 &&
         !held_[row];
}

std::optional<std::string> LeafProof::read_numbers() {
  const auto d = block_.dimension;
  std::vector<double> tangential(held_.size(), 0);
  auto number = numbers_.begin();
  for (std::size_t i = 0; i < model_.candidates(); ++i) {
    const bool contact = contains(contact_, i);
    for (std::size_t k = contact ? 1 : 0; k < d; ++k) {
      if (!held_[d * i + k]) unknowns_.push_back(d * i + k);
      if (!contact) continue;
      if (block_.friction[i] == 0 && *number != 0) {
        return block_.names[i] + " has no friction, but a tangential reaction";
      }
      if (!held_[d * i + k]) tangential[d * i + k] = *number;
      ++number;
    }
  }
  tangential_ = DyadicList(tangential);
  if (model_.motions() > 0) mean_ = model_.own_coefficients(numbers_.last(model_.motions()));
  if (!all_finite(mean_)) return "its numbers are too large to compute with";
  return {};
}

// With v the displacements that close the gaps, u = u' + v: u' is zero at the normals of U under
// the load f - K v. The motion at the normals is rounded, be it to zero.
void LeafProof::close_gaps(const RegularisedStiffness& stiffness) {
  const Dyadic count(static_cast<double>(held_.size()));
  forces_ = load_forces_;
  force_error_ = load_error_ + tangential_error_ + stiffness.norm() * count * motion_.error;
  const auto closing = norm_above(closing_);
  if (closing.sign() != 0) {
    forces_ -= block_.stiffness.middle * closing_;
    force_error_ = force_error_ + block_.stiffness.radius * closing;
  }
  right_ = tangential_;
  right_ += forces_;
}

// The displacements x without a motion are computed first. The sliding modes then move them such
// that their mean motion is nearly the recorded one, which is taken out: the rest is as small as
// the strain, also far from the contacts. Any displacement is admissible where no reaction is given.
void LeafProof::add_motion(const RegularisedStiffness& stiffness,
                           const std::vector<Rationals>& sliding) {
  constexpr int checks_of_first = 2;  // the first approximation may be checked twice
  int check = 0;
  DyadicList at_rest;
  close_gaps(stiffness);
  const auto ignored =
      stiffness.solve(unknowns_, right_,
                      [&](const auto& u, const auto&, const auto&) -> std::optional<std::string> {
                        const bool accurate = ++check > checks_of_first && has_settled(at_rest, u);
                        at_rest = u;
                        if (!accurate) return "more digits are needed";
                        return {};
                      });
  static_cast<void>(ignored);
  if (at_rest.size() == 0) return;
  const auto sliding_motion = model_.missing_motion(mean_, at_rest, sliding);
  Rationals mean;
  for (const double each : mean_) mean.emplace_back(each);
  const auto slid = restricted_to_candidates(block_.motions, sliding_motion);
  motion_ = restricted_to_candidates(block_.motions, mean);
  std::vector<Dyadic> moved(held_.size());
  for (std::size_t row = 0; row < held_.size(); ++row) {
    if (held_[row]) moved[row] = slid.values[row] - motion_.values[row];
  }
  for (const int i : contact_) {
    const auto normal = block_.dimension * static_cast<std::size_t>(i);
    moved[normal] = Dyadic() - motion_.values[normal];
  }
  closing_ += DyadicList(moved);
}

Dyadic LeafProof::shear_above(const Dyadic& s, const DyadicList& r, const Dyadic& error,
                              std::size_t candidate) const {
  const auto d = block_.dimension;
  bool computed = false;
  Dyadic sum;
  for (std::size_t row = d * candidate + 1; row < d * (candidate + 1); ++row) {
    computed = computed || held_[row];
    sum = sum + square(held_[row] ? reaction(r, row) : tangential_[row]);
  }
  const auto shear = s * sqrt_above(sum);
  return shear + (computed ? error : s * tangential_error_);
}

std::optional<std::string> LeafProof::check_feasible(const RegularisedStiffness& stiffness,
                                                     const DyadicList& u, const DyadicList& r,
                                                     const Dyadic& unknown) const {
  const auto d = block_.dimension;
  const auto& s = *stiffness.min_eigenvalue();
  Dyadic rest_squared;
  for (const auto row : unknowns_) rest_squared = rest_squared + square(r[row] - right_[row]);
  // s times the errors of u and of K u minus the load
  const auto rest = sqrt_above(rest_squared) + unknown + force_error_;
  const auto error = stiffness.norm() * rest + s * (unknown + force_error_);
  const auto off = s * motion_.error;
  auto moved = u;
  moved += closing_;
  moved += motion_.values;
  Dyadic sum;  // s times the sum of the normal reactions, and its error
  Dyadic spread;
  for (std::size_t i = 0; i < model_.candidates(); ++i) {
    const auto& name = block_.names[i];
    if (!contains(contact_, i)) {
      if (!(s * (moved[d * i] + gaps_[i]) > rest + off)) return name + " is not proved to separate";
      continue;
    }
    const auto normal = s * reaction(r, d * i);
    sum = sum + normal;
    spread = spread + error;
    const auto pressure = normal - error;
    if (pressure.sign() <= 0) return name + " is not pressed against the obstacle";
    if (model_.friction()[i].sign() == 0) continue;  // r_t = 0 is required
    if (!(model_.friction()[i] * pressure > shear_above(s, r, error, i)))
      return name + " slips, or is at the limit of friction";
  }
  if (grip_ != nullptr) {
    if (spread.scaled(sum_digits) > sum) return "the sum of its normal reactions is not known";
    *grip_ = {(sum - spread).rational() / s.rational(), (sum + spread).rational() / s.rational()};
  }
  return {};
}

}  // namespace kusabi::verify
