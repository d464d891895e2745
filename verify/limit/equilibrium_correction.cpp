// Equilibrium correction by a left inverse of B' over the members with slack, approximated in
// doubles and then bounded.
//
// G = (B W B')^-1 B W, with a weight for each member, approximates a left inverse; E = I - G B' is
// its error, and u = G B'u + E u. With the scaled motion v_e = Y_e |u_e| and |E| <= 1/2 in the
// corresponding norm, max v <= 2 sum_i max_e Y_e |G_ei| |b_i'u|, and therefore
//   |u_e| <= sum_i |G_ei| |b_i'u| + (sum_k |E_ek| / Y_k) max v.
#include "verify/limit/equilibrium_correction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "verify/arithmetic/disjoint_sets.hpp"
#include "verify/limit/gram.hpp"

namespace kusabi::verify {
namespace {

// Smaller numbers are replaced by zero, or by this number in upper bounds, so that products of
// two do not underflow.
constexpr double tiny = 1e-140;

// Bound of the relative rounding error of sums and products of nonnegative numbers: 2^-53 for each
// of some millions of terms.
constexpr double all_roundings = 0x1p-28;

template <class Visit>
void each_displacement(const MemberColumns& members, std::size_t i, const Visit& visit) {
  for (const auto& [e, value] : members.columns[i]) visit(e);
  if (members.errors.empty()) return;
  for (const auto& [e, error] : members.errors[i]) visit(e);
}

// The slack of the members that can carry a defect. If only one member acts on a displacement
// without a defect, equilibrium makes its force zero, so its slack is set to zero; this is repeated
// until nothing changes.
std::vector<double> slack_of_use(const MemberColumns& members, std::vector<double> slack,
                                 const std::vector<double>& defect) {
  std::vector<std::vector<std::size_t>> at(members.displacements);
  for (std::size_t i = 0; i < slack.size(); ++i) {
    if (slack[i] <= tiny) slack[i] = 0;
    if (slack[i] == 0) continue;
    each_displacement(members, i, [&](std::size_t e) {
      if (at[e].empty() || at[e].back() != i) at[e].push_back(i);
    });
  }
  std::vector<std::size_t> count;
  std::vector<std::size_t> ends;
  for (std::size_t e = 0; e < at.size(); ++e) {
    count.push_back(at[e].size());
    if (count[e] == 1 && defect[e] == 0) ends.push_back(e);
  }
  while (!ends.empty()) {
    const auto e = ends.back();
    ends.pop_back();
    const auto last = std::ranges::find_if(at[e], [&](std::size_t i) { return slack[i] > 0; });
    if (last == at[e].end()) continue;
    const auto member = *last;
    slack[member] = 0;
    each_displacement(members, member, [&](std::size_t other) {
      if (std::ranges::find(at[other], member) == at[other].end()) return;
      std::erase(at[other], member);
      if (--count[other] == 1 && defect[other] == 0) ends.push_back(other);
    });
  }
  return slack;
}

/// The components of a truss that carry defects.
struct DefectivePart {
  std::vector<std::size_t> displacements;
  std::vector<std::size_t> members;
};

// The components with a defect. Nothing if no member with slack acts on a defect.
std::optional<DefectivePart> part_with_defects(const MemberColumns& members,
                                               const std::vector<double>& slack,
                                               const std::vector<double>& defect) {
  DisjointSets pieces(members.displacements);  // connected by members with slack
  std::vector<bool> reached(members.displacements);
  for (std::size_t i = 0; i < slack.size(); ++i) {
    if (slack[i] <= tiny) continue;
    std::optional<std::size_t> first;
    each_displacement(members, i, [&](std::size_t e) {
      reached[e] = true;
      if (first) pieces.join(e, *first);
      first = e;
    });
  }
  std::vector<bool> wanted(members.displacements);
  for (std::size_t e = 0; e < defect.size(); ++e) {
    if (defect[e] == 0) continue;
    if (!reached[e]) return {};
    wanted[pieces.of(e)] = true;
  }
  DefectivePart part;
  for (std::size_t e = 0; e < defect.size(); ++e) {
    if (reached[e] && wanted[pieces.of(e)]) part.displacements.push_back(e);
  }
  for (std::size_t i = 0; i < slack.size(); ++i) {
    if (slack[i] <= tiny) continue;
    bool within = false;
    each_displacement(members, i, [&](std::size_t e) { within = within || wanted[pieces.of(e)]; });
    if (within) part.members.push_back(i);
  }
  return part;
}

/// Rows of G and of E, computed one by one, and sums over them.
class Reach {
 public:
  Reach(const MemberColumns& members, const DefectivePart& part, const std::vector<double>& weight)
      : members_(members),
        part_(part),
        weight_(weight),
        gram_(members.columns, part.members, weight, part.displacements, members.displacements) {}

  // Nothing if the approximate inverse is too inaccurate.
  std::optional<std::vector<double>> forces(const std::vector<double>& defect);

 private:
  bool row(std::size_t e, double defect);

  const MemberColumns& members_;
  const DefectivePart& part_;
  const std::vector<double>& weight_;
  Gram gram_;
  std::vector<double> size_;          // Y, by place
  std::vector<double> solution_;      // row e of (B W B')^-1
  std::vector<double> missed_;        // row e of E, by place
  std::vector<double> missed_error_;  // bound of the error of `missed_`
  std::vector<double> direct_;        // sum_e defect_e |G_ei|
  std::vector<double> largest_;       // max_e Y_e |G_ei|
  double rest_ = 0;                   // sum_e defect_e sum_k |E_ek| / Y_k
};

bool Reach::row(std::size_t e, double defect) {
  const auto here = gram_.place(e);
  std::ranges::fill(solution_, 0.0);
  std::ranges::fill(missed_, 0.0);
  std::ranges::fill(missed_error_, 0.0);
  solution_[here] = 1;
  gram_.solve(solution_);
  missed_[here] = 1;
  // Relative bound of the rounding errors of a sum of products, one for each member at a
  // displacement.
  const double rounded_off = 0x1p-52 * static_cast<double>(part_.members.size() + 4);
  for (const auto i : part_.members) {
    double inverse = 0;  // G_ei
    for (const auto& [k, value] : members_.columns[i]) inverse += solution_[gram_.place(k)] * value;
    inverse *= weight_[i];
    if (!std::isfinite(inverse)) return false;
    const double size = std::abs(inverse);
    direct_[i] += defect * size;
    largest_[i] = std::max(largest_[i], size_[here] * size);
    for (const auto& [k, value] : members_.columns[i]) {
      missed_[gram_.place(k)] -= inverse * value;
      missed_error_[gram_.place(k)] += std::abs(inverse * value) * rounded_off;
    }
    if (members_.errors.empty()) continue;
    for (const auto& [k, error] : members_.errors[i]) {
      missed_error_[gram_.place(k)] += size * error;
    }
  }
  double total = 0;
  for (std::size_t k = 0; k < missed_.size(); ++k) {
    total += (std::abs(missed_[k]) + missed_error_[k] + tiny) / size_[k];
  }
  rest_ += defect * total;
  constexpr double half = 0.5 * (1 - all_roundings);
  return size_[here] * total <= half;
}

std::optional<std::vector<double>> Reach::forces(const std::vector<double>& defect) {
  if (!gram_.definite()) return {};
  const auto n = part_.displacements.size();
  for (const double each : gram_.diagonal()) {
    if (!(each > tiny)) return {};
    size_.push_back(std::sqrt(each));
  }
  solution_.resize(n);
  missed_.resize(n);
  missed_error_.resize(n);
  direct_.assign(members_.columns.size(), 0.0);
  largest_.assign(members_.columns.size(), 0.0);
  for (const auto e : part_.displacements) {
    if (!row(e, defect[e])) return {};
  }
  std::vector<double> forces(members_.columns.size(), 0.0);
  for (const auto i : part_.members) {
    forces[i] = (direct_[i] + 2 * rest_ * largest_[i]) * (1 + all_roundings) + tiny * tiny;
    // A defect beyond all doubles is infinite, and its product with zero is not a number.
    if (!std::isfinite(forces[i])) return {};
  }
  return forces;
}

// The slack of members that act only on displacements with a defect.
std::vector<double> slack_on_defects(const MemberColumns& members, std::vector<double> slack,
                                     const std::vector<double>& defect) {
  for (std::size_t i = 0; i < slack.size(); ++i) {
    each_displacement(members, i, [&](std::size_t e) {
      if (defect[e] == 0) slack[i] = 0;
    });
  }
  return slack;
}

// By the members with slack.
std::variant<std::vector<double>, std::string> forces_by(const MemberColumns& members,
                                                         const std::vector<double>& slack,
                                                         const std::vector<double>& defect) {
  const auto part = part_with_defects(members, slack, defect);
  if (!part) return "forces are not in equilibrium where no member has slack";
  if (part->displacements.empty()) return std::vector<double>(slack.size(), 0.0);
  double max_slack = 0;
  for (const auto i : part->members) max_slack = std::max(max_slack, slack[i]);
  std::vector<double> best;
  double min_excess = std::numeric_limits<double>::infinity();
  // Weights in proportion to the slack are tried first; if they are too uneven for doubles, more
  // even ones.
  for (const double power : {1.0, 0.5, 0.0}) {
    std::vector<double> weight(slack.size(), 0.0);
    for (const auto i : part->members)
      weight[i] = std::max(std::pow(slack[i] / max_slack, power), tiny);
    auto forces = Reach(members, *part, weight).forces(defect);
    if (!forces) continue;
    double excess = 0;
    for (const auto i : part->members) excess = std::max(excess, (*forces)[i] / slack[i]);
    if (excess < min_excess) {
      min_excess = excess;
      best = std::move(*forces);
    }
    if (excess <= 1) break;
  }
  if (best.empty()) return "no bound of motions by elongations was found";
  return best;
}

}  // namespace

// Members beside the defects may be a mechanism whose forces are zero.
std::variant<std::vector<double>, std::string> forces_against_defects(
    const MemberColumns& members, const std::vector<double>& slack_of_all,
    const std::vector<double>& defect) {
  const auto slack = slack_of_use(members, slack_of_all, defect);
  auto forces = forces_by(members, slack, defect);
  if (std::holds_alternative<std::vector<double>>(forces)) return forces;
  auto fewer = forces_by(members, slack_on_defects(members, slack, defect), defect);
  return std::holds_alternative<std::vector<double>>(fewer) ? fewer : forces;
}

std::vector<double> forces_against_unit_defects(const MemberColumns& members) {
  const std::vector<double> of_members(members.columns.size(), 1.0);
  const std::vector<double> of_displacements(members.displacements, 1.0);
  const auto part = part_with_defects(members, of_members, of_displacements);
  if (!part) return {};
  return Reach(members, *part, of_members).forces(of_displacements).value_or(std::vector<double>());
}

double double_above(const Dyadic& value) {
  if (value.sign() == 0) return 0;
  const double number = value.nearest() * (1 + 0x1p-50);
  return number < tiny ? tiny : number;
}

double double_below(const Dyadic& value) {
  const double number = value.nearest() * (1 - 0x1p-50);
  return number < tiny ? 0 : number;
}

}  // namespace kusabi::verify
