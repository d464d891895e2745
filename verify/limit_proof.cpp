// The two ends, exactly.
#include "verify/limit_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace kusabi::verify {
namespace {

void add_product(Dyadic& sum, double a, double b) {
  if (a != 0 && b != 0) sum = sum + Dyadic(a) * Dyadic(b);
}

}  // namespace

LimitProof::LimitProof(const LimitCertificate& certificate, LimitErrors errors)
    : certificate_(certificate), errors_(std::move(errors)) {
  for (const auto& cut : certificate.cuts) {
    // e + k f_R - B y
    std::vector<Dyadic> load(certificate.displacements);
    load[certificate.uncertain[cut.column].first] = Dyadic(1.0);
    auto& rounded = defects_.emplace_back();
    const auto missing = defect(cut.forces, std::move(load), cut.factor);
    for (std::size_t e = 0; e < missing.size(); ++e) {
      if (missing[e].sign() != 0) rounded.emplace_back(e, double_above(missing[e]));
    }
  }
}

// |load + factor f_R - B forces|, by displacement, with what the errors of f_R and B add.
std::vector<Dyadic> LimitProof::defect(const Sparse& forces, std::vector<Dyadic> load,
                                       double factor) const {
  for (std::size_t e = 0; e < load.size(); ++e) {
    add_product(load[e], factor, certificate_.reference[e]);
  }
  for (const auto& [member, force] : forces) {
    for (const auto& [e, entry] : certificate_.columns[member]) add_product(load[e], -force, entry);
  }
  for (auto& each : load) each = absolute(each);
  if (!errors_.reference.empty() && factor != 0) {
    for (std::size_t e = 0; e < load.size(); ++e) {
      load[e] = load[e] + Dyadic(std::abs(factor)) * errors_.reference[e];
    }
  }
  if (errors_.columns.empty()) return load;
  for (const auto& [member, force] : forces) {
    if (force == 0) continue;
    for (const auto& [e, error] : errors_.columns[member]) {
      load[e] = load[e] + Dyadic(std::abs(force)) * error;
    }
  }
  return load;
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
  for (std::size_t e = 0; e < u.size(); ++e) {
    const Dyadic size(std::abs(u[e]));
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
    if (!errors_.columns.empty()) {
      const Dyadic most(std::max(certificate_.compression[i], certificate_.tension[i]));
      for (const auto& [e, error] : errors_.columns[i]) {
        value = value + most * Dyadic(std::abs(u[e])) * error;
      }
    }
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
  std::vector<Dyadic> defects(certificate.displacements);
  Dyadic value(node.factor);
  for (const auto& [c, share] : node.shares) {
    const auto& cut = certificate.cuts[c];
    share_of[cut.column] = share_of[cut.column] + Dyadic(share);
    add_product(value, -share, std::abs(cut.factor));
    for (const auto& [i, force] : cut.forces) add_product(taken[i], share, std::abs(force));
    for (const auto& [e, missing] : defects_[c]) add_product(defects[e], share, missing);
  }
  // f_D + sum over decided signs of s (alpha weight + nu) e + lambda f_R - B q
  std::vector<Dyadic> load;
  for (const double dead : certificate.dead) load.emplace_back(dead);
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
  const auto own = defect(forces, std::move(load), node.factor);
  std::vector<double> rounded;
  for (std::size_t e = 0; e < defects.size(); ++e) {
    const Dyadic dead = errors_.dead.empty() ? Dyadic() : errors_.dead[e];
    rounded.push_back(double_above(defects[e] + own[e] + dead));
  }
  std::vector<double> slack;
  for (std::size_t i = 0; i < certificate.members(); ++i) {
    const Dyadic force(node.forces[i]);
    const Dyadic tension = Dyadic(certificate.tension[i]) - force - taken[i];
    const Dyadic compression = Dyadic(certificate.compression[i]) + force - taken[i];
    const Dyadic& least = tension < compression ? tension : compression;
    if (least.sign() < 0) return "member " + std::to_string(i) + " yields";
    slack.push_back(double_below(least));
  }
  const MemberColumns members{certificate.displacements, certificate.columns, errors_.columns};
  const auto found = forces_against_defects(members, slack, rounded);
  if (const auto* why = std::get_if<std::string>(&found)) return *why;
  const auto& against = std::get<std::vector<double>>(found);
  for (std::size_t i = 0; i < slack.size(); ++i) {
    if (against[i] > slack[i]) {
      return "member " + std::to_string(i) + " yields for what equilibrium lacks";
    }
  }
  return value.rational();
}

bool LimitProof::shows_no_factor() const {
  const auto& reference = certificate_.reference;
  if (certificate_.motion.size() != reference.size()) return false;
  std::vector<mpq_class> motion(certificate_.motion.begin(), certificate_.motion.end());
  const auto largest =
      std::ranges::max_element(reference, {}, [](double value) { return std::abs(value); });
  mpq_class work = 0;
  for (std::size_t e = 0; e < motion.size(); ++e) work += reference[e] * motion[e];
  motion[static_cast<std::size_t>(largest - reference.begin())] -= work / mpq_class(*largest);
  mpq_class excess = 0;  // of the work of the dead load
  for (std::size_t e = 0; e < motion.size(); ++e) excess += certificate_.dead[e] * motion[e];
  for (std::size_t j = 0; j < certificate_.load.size(); ++j) {
    const auto& [e, weight] = certificate_.uncertain[j];
    excess += mpq_class(certificate_.load[j]) * weight * motion[e];
  }
  const int sign = sgn(excess);
  excess = abs(excess);
  for (std::size_t i = 0; i < certificate_.members(); ++i) {
    mpq_class elongation = 0;
    for (const auto& [e, entry] : certificate_.columns[i]) elongation += entry * motion[e];
    elongation *= sign;
    const double yield = elongation < 0 ? certificate_.compression[i] : certificate_.tension[i];
    excess -= yield * abs(elongation);
  }
  return excess > 0;
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
