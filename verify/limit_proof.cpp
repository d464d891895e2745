// The two ends, exactly.
#include "verify/limit_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "verify/cholesky.hpp"
#include "verify/numbering.hpp"

namespace kusabi::verify {
namespace {

void add_product(Dyadic& sum, double a, double b) {
  if (a != 0 && b != 0) sum = sum + Dyadic(a) * Dyadic(b);
}

}  // namespace

LimitProof::LimitProof(const LimitCertificate& certificate, LimitErrors errors)
    : certificate_(certificate), errors_(std::move(errors)) {
  for (const auto& error : errors_.dead) dead_error_ = dead_error_ + error;
  for (const auto& error : errors_.reference) reference_error_ = reference_error_ + error;
  bound_motions();
  for (const auto& cut : certificate.cuts) {
    // rho = e + k f_R - B y
    std::vector<Dyadic> load(certificate.displacements);
    load[certificate.uncertain[cut.column].first] = Dyadic(1.0);
    for (std::size_t e = 0; e < load.size(); ++e) {
      add_product(load[e], cut.factor, certificate.reference[e]);
    }
    defects_.push_back(defect(cut.forces, std::move(load)) +
                       Dyadic(std::abs(cut.factor)) * reference_error_);
  }
}

Dyadic LimitProof::column_error(std::size_t member) const {
  return errors_.columns.empty() ? Dyadic() : errors_.columns[member];
}

// |load - B q|_1
Dyadic LimitProof::defect(const Sparse& forces, std::vector<Dyadic> load) const {
  Dyadic total;
  for (const auto& [member, force] : forces) {
    for (const auto& [e, entry] : certificate_.columns[member]) add_product(load[e], -force, entry);
    total = total + Dyadic(std::abs(force)) * column_error(member);
  }
  for (const auto& each : load) total = total + absolute(each);
  return total;
}

namespace {

// The factor of B B', and in which order it has the displacements.
struct Gram {
  std::vector<std::size_t> place;  // of each displacement
  std::optional<Cholesky> factor;
};

Gram factor_of_gram(const LimitCertificate& certificate) {
  const auto n = certificate.displacements;
  constexpr std::size_t largest_profile = 50'000'000;
  std::vector<std::map<std::size_t, double>> entries(n);
  for (const auto& column : certificate.columns) {
    for (const auto& [row, a] : column) {
      for (const auto& [other, b] : column) entries[row][other] += a * b;
    }
  }
  std::vector<std::vector<std::size_t>> neighbours(n);
  for (std::size_t row = 0; row < n; ++row) {
    for (const auto& [other, value] : entries[row]) {
      if (other != row) neighbours[row].push_back(other);
    }
  }
  const auto order = narrow_order(neighbours);
  Gram gram;
  gram.place.resize(n);
  for (std::size_t at = 0; at < n; ++at) gram.place[order[at]] = at;
  std::vector<std::size_t> first(n);
  for (std::size_t at = 0; at < n; ++at) {
    first[at] = at;
    for (const auto& [other, value] : entries[order[at]]) {
      first[at] = std::min(first[at], gram.place[other]);
    }
  }
  const Profile profile(std::move(first));
  if (profile.entries() > largest_profile) return gram;
  std::vector<double> matrix(profile.entries(), 0.0);
  for (std::size_t at = 0; at < n; ++at) {
    for (const auto& [other, value] : entries[order[at]]) {
      if (gram.place[other] <= at) matrix[profile.at(at, gram.place[other])] = value;
    }
  }
  gram.factor = Cholesky::of(profile, matrix);
  return gram;
}

}  // namespace

// G = (B B')^-1 B is a guess of a left inverse of B'. With E = I - G B' and ‖E‖_inf <= 1/2,
// u = G B'u + E u gives ‖u‖_inf <= 2 max_e sum_i |G_ei| |b_i'u|.
void LimitProof::bound_motions() {
  const auto n = certificate_.displacements;
  if (certificate_.members() < n) return;  // fewer elongations than displacements
  const auto [place, factor] = factor_of_gram(certificate_);
  if (!factor) return;
  std::vector<double> largest(certificate_.members(), 0.0);
  std::vector<double> guess(n);  // row e of (B B')^-1
  for (std::size_t e = 0; e < n; ++e) {
    std::fill(guess.begin(), guess.end(), 0.0);
    guess[place[e]] = 1;
    factor->solve(guess);
    std::vector<Dyadic> error(n);  // row e of E
    error[e] = Dyadic(1.0);
    Dyadic total;
    for (std::size_t i = 0; i < certificate_.members(); ++i) {
      double entry = 0;  // of G
      for (const auto& [row, value] : certificate_.columns[i]) entry += guess[place[row]] * value;
      if (!std::isfinite(entry)) return;
      largest[i] = std::max(largest[i], std::abs(entry));
      for (const auto& [row, value] : certificate_.columns[i]) {
        add_product(error[row], -entry, value);
      }
      total = total + Dyadic(std::abs(entry)) * column_error(i);
    }
    for (const auto& each : error) total = total + absolute(each);
    if (total > Dyadic(0.5)) return;
  }
  for (const double each : largest) reach_.push_back(Dyadic(2.0) * Dyadic(each));
}

std::variant<mpq_class, std::string> LimitProof::upper() const {
  const auto& u = certificate_.motion;
  for (const double zeta : certificate_.load) {
    if (std::abs(zeta) > certificate_.alpha) return "the load is outside of its bounds";
  }
  Dyadic work;  // of f_R
  Dyadic value;
  for (std::size_t e = 0; e < u.size(); ++e) {
    add_product(work, certificate_.reference[e], u[e]);
    add_product(value, -certificate_.dead[e], u[e]);
  }
  // What the errors of the loads add to the value, and take from or add to the work.
  Dyadic doubt;
  double largest = 0;
  for (std::size_t e = 0; e < u.size(); ++e) {
    const Dyadic size(std::abs(u[e]));
    largest = std::max(largest, std::abs(u[e]));
    if (!errors_.dead.empty()) value = value + errors_.dead[e] * size;
    if (!errors_.reference.empty()) doubt = doubt + errors_.reference[e] * size;
  }
  if (!(work > doubt)) return "the reference load does no work on the motion";
  for (std::size_t j = 0; j < certificate_.load.size(); ++j) {
    const auto& [e, weight] = certificate_.uncertain[j];
    value = value - Dyadic(certificate_.load[j]) * Dyadic(weight) * Dyadic(u[e]);
  }
  for (std::size_t i = 0; i < certificate_.members(); ++i) {
    Dyadic elongation;
    for (const auto& [e, entry] : certificate_.columns[i]) add_product(elongation, entry, u[e]);
    value = value + Dyadic(std::max(certificate_.compression[i], certificate_.tension[i])) *
                        Dyadic(largest) * column_error(i);
    const double yield =
        elongation.sign() < 0 ? certificate_.compression[i] : certificate_.tension[i];
    value = value + Dyadic(yield) * absolute(elongation);
  }
  const auto divisor = value.sign() < 0 ? work + doubt : work - doubt;
  return mpq_class(value.rational() / divisor.rational());
}

std::variant<mpq_class, std::string> LimitProof::lower(const LimitNode& node) const {
  const auto& certificate = certificate_;
  const auto m = certificate.uncertain.size();
  // What the shares of the cuts take of each member, and what they leave undone.
  std::vector<Dyadic> taken(certificate.members());
  std::vector<Dyadic> share_of(m);
  Dyadic value(node.factor);
  Dyadic defects = dead_error_ + Dyadic(std::abs(node.factor)) * reference_error_;
  for (const auto& [c, share] : node.shares) {
    const auto& cut = certificate.cuts[c];
    share_of[cut.column] = share_of[cut.column] + Dyadic(share);
    add_product(value, -share, std::abs(cut.factor));
    for (const auto& [i, force] : cut.forces) add_product(taken[i], share, std::abs(force));
    defects = defects + Dyadic(share) * defects_[c];
  }
  // r = f_D + sum over decided signs of s (alpha weight + nu) e + lambda f_R - B q
  std::vector<Dyadic> load;
  for (std::size_t e = 0; e < certificate.displacements; ++e) {
    load.emplace_back(certificate.dead[e]);
    add_product(load[e], node.factor, certificate.reference[e]);
  }
  for (std::size_t j = 0; j < m; ++j) {
    const auto& [e, weight] = certificate.uncertain[j];
    const Dyadic needed = Dyadic(certificate.alpha) * Dyadic(weight);
    if (node.signs[j] == 0) {
      if (share_of[j] < needed) return "the cuts of a column have too small a share";
    } else {
      const Dyadic decided = needed + Dyadic(node.one_sided[j]);
      load[e] = node.signs[j] > 0 ? load[e] + decided : load[e] - decided;
    }
  }
  Sparse forces;
  for (std::size_t i = 0; i < node.forces.size(); ++i) forces.emplace_back(i, node.forces[i]);
  defects = defects + defect(forces, std::move(load));
  for (std::size_t i = 0; i < certificate.members(); ++i) {
    const Dyadic all = taken[i] + defects * reach_[i];
    const Dyadic force(node.forces[i]);
    if (Dyadic(certificate.tension[i]) < force + all ||
        Dyadic(certificate.compression[i]) + force < all) {
      return "member " + std::to_string(i) + " yields";
    }
  }
  return value.rational();
}

namespace {

// Whether `nodes`, all of which have the signs decided so far, cover all others. A column that all
// of them decide splits the signs and the nodes alike.
std::optional<std::string> flaw(std::span<const LimitNode*> nodes, std::vector<bool>& decided,
                                std::size_t depth) {
  if (nodes.empty()) return "no node covers some combination of signs";
  for (std::size_t j = 0; j < decided.size(); ++j) {
    if (decided[j] || std::ranges::any_of(nodes, [j](const auto* n) { return n->signs[j] == 0; })) {
      continue;
    }
    decided[j] = true;
    const auto middle = std::partition(nodes.begin(), nodes.end(),
                                       [j](const auto* node) { return node->signs[j] > 0; });
    const auto positive = static_cast<std::size_t>(middle - nodes.begin());
    auto found = flaw(nodes.first(positive), decided, depth + 1);
    if (!found) found = flaw(nodes.subspan(positive), decided, depth + 1);
    decided[j] = false;
    return found;
  }
  const auto whole = [depth](const LimitNode* node) {
    const auto count =
        node->signs.size() - static_cast<std::size_t>(std::ranges::count(node->signs, 0));
    return count == depth;
  };
  // A node that decides nothing more covers all that is below.
  if (std::ranges::any_of(nodes, whole)) return {};
  return "the nodes do not come from a tree: no sign is decided in all of some";
}

double towards(const mpq_class& value, double limit) {
  double number = value.get_d();
  if (std::isinf(number)) number = std::copysign(std::numeric_limits<double>::max(), number);
  const auto beyond = [&] { return limit < 0 ? number > value : number < value; };
  while (std::isfinite(number) && beyond()) number = std::nextafter(number, limit);
  return number;
}

}  // namespace

std::optional<std::string> flaw_of_sign_cover(const LimitCertificate& certificate) {
  std::vector<const LimitNode*> nodes;
  for (const auto& node : certificate.nodes) nodes.push_back(&node);
  std::vector<bool> decided(certificate.uncertain.size(), false);
  return flaw(nodes, decided, 0);
}

double rounded_down(const mpq_class& value) {
  return towards(value, -std::numeric_limits<double>::infinity());
}

double rounded_up(const mpq_class& value) {
  return towards(value, std::numeric_limits<double>::infinity());
}

}  // namespace kusabi::verify
