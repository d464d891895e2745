// Directions, yield forces and loads are compared as those of other limit loads.
#include "verify/limit/loss_claim.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "verify/limit/exact_truss.hpp"
#include "verify/limit/limit_consistency.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/loss_cover.hpp"
#include "verify/structure/assembly.hpp"

namespace kusabi::verify {
namespace {

support::IndexSet set_of(const std::vector<std::size_t>& members) {
  support::IndexSet set;
  for (const auto member : members) set.insert(static_cast<int>(member));
  return set;
}

}  // namespace

LimitCertificate recorded_loads(const Structure& truss) {
  const Freedom freedom(truss);
  LimitCertificate loads;
  loads.displacements = freedom.count;
  for (const auto& bar : truss.bars) {
    loads.tension.push_back(bar.tension);
    loads.compression.push_back(bar.compression);
    auto& column = loads.columns.emplace_back();
    const auto cosines = direction(truss, bar).cosines;
    for (std::size_t axis = 0; axis < truss.dimension; ++axis) {
      const double cosine = (cosines[axis].lower() + cosines[axis].upper()).scaled(-1).nearest();
      if (const auto e = freedom.number[bar.first][axis]; e != Freedom::none && cosine != 0)
        column.emplace_back(e, -cosine);
      if (const auto e = freedom.number[bar.second][axis]; e != Freedom::none && cosine != 0)
        column.emplace_back(e, cosine);
    }
  }
  loads.dead = sum_of<double>(truss.dead, truss, freedom);
  loads.reference = sum_of<double>(truss.reference, truss, freedom);
  for (std::size_t j = 0; j < truss.uncertain->size(); ++j) {
    auto& column = loads.uncertain.emplace_back();
    for (const auto& each : (*truss.uncertain)[j]) {
      const auto e = freedom.number[each.node][each.axis];
      if (e != Freedom::none) column.emplace_back(e, each.weight);
    }
    loads.alpha.push_back(*truss.half_widths[j]);
    loads.names.push_back(truss.load_names[j]);
  }
  return loads;
}

namespace {

// A quotient rounded down or up.
double quotient(double dividend, double divisor, bool up) {
  const mpq_class exact = mpq_class(dividend) / mpq_class(divisor);
  return up ? rounded_up(exact) : rounded_down(exact);
}

}  // namespace

LossClaim::LossClaim(const LossStatement& statement, std::optional<Structure> structure)
    : statement_(statement), evidence_(recorded_loads(statement.truss)) {
  std::vector<Bar> whole;  // with the yield forces of the file
  if (structure) {
    whole = structure->bars;
    for (auto& bar : structure->bars) {
      bar.tension /= statement.sudden;
      bar.compression /= statement.sudden;
    }
    if (evidence_.uncertain.empty()) {  // the dead load as given
      structure->uncertain.emplace();
      structure->half_widths.clear();
    }
  } else {
    structure = statement.truss;
  }
  auto found = limit_consistency(evidence_, *structure);
  if (auto* const why = std::get_if<std::string>(&found)) {
    difference_ = std::move(*why);
    return;
  }
  truss_ = std::get<LimitTruss>(std::move(found));
  exact_ = exact_truss(*structure);
  add_uncertain(evidence_.uncertain, evidence_.alpha, exact_);
  tension_ = evidence_.tension;
  compression_ = evidence_.compression;
  if (!whole.empty()) divide_yield_forces(whole);
  load_names_ = std::move(structure->load_names);
  for (const auto& bar : structure->bars)
    names_.push_back(structure->names[bar.first] + "-" + structure->names[bar.second]);
  evidence_.load = statement.load;
  evidence_.motion = statement.motion;
  proof_.emplace(evidence_, *truss_);
}

void LossClaim::divide_yield_forces(const std::vector<Bar>& bars) {
  const double sudden = statement_.sudden;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto& [tension, compression] = std::pair(bars[i].tension, bars[i].compression);
    exact_.tension[i] = mpq_class(tension) / mpq_class(sudden);
    exact_.compression[i] = mpq_class(compression) / mpq_class(sudden);
    evidence_.tension[i] = quotient(tension, sudden, false);
    evidence_.compression[i] = quotient(compression, sudden, false);
    tension_[i] = quotient(tension, sudden, true);
    compression_[i] = quotient(compression, sudden, true);
  }
}

std::vector<std::pair<std::string, double>> LossClaim::half_widths() const {
  std::vector<std::pair<std::string, double>> all;
  for (std::size_t j = 0; j < truss_->half_widths.size(); ++j)
    all.emplace_back(load_names_.empty() ? "" : load_names_[j], truss_->half_widths[j]);
  return all;
}

std::vector<std::string> LossClaim::check_loss(double& upper) const {
  std::vector<std::string> refusals;
  auto remaining = evidence_;
  remaining.tension = tension_;
  remaining.compression = compression_;
  for (const auto member : statement_.lost)
    remaining.tension[member] = remaining.compression[member] = 0;
  const LimitProof proof(remaining, *truss_);
  upper = -std::numeric_limits<double>::infinity();
  if (statement_.fatal) {
    if (!proof.shows_no_factor())
      refusals.emplace_back("the motion does not prove that no load factor remains after the loss");
    return refusals;
  }
  const auto found = proof.upper();
  if (const auto* const why = std::get_if<std::string>(&found)) {
    refusals.push_back("upper bound: " + *why);
  } else {
    upper = rounded_up(std::get<mpq_class>(found));
    if (std::isinf(upper))
      refusals.emplace_back("the upper bound exceeds the range of double precision");
  }
  if (!statement_.lower) return refusals;
  std::vector<support::IndexSet> supports;
  for (const auto& state : statement_.states) supports.push_back(set_of(state.support));
  const LossCover cover(supports, set_of(statement_.kept), static_cast<int>(statement_.maximum));
  if (const auto& flaw = cover.flaw()) {
    std::string why = "no state is left after the loss of";
    for (const int member : *flaw) why += ' ' + names_[static_cast<std::size_t>(member)];
    refusals.push_back(flaw->empty() ? "the certificate has no states" : why);
  }
  return refusals;
}

// By enclosures, and exactly only if these do not prove it: a state may exist only because loads
// balance exactly.
std::optional<std::string> LossClaim::refusal_of_state(std::size_t number) const {
  const auto& state = statement_.states[number];
  const auto enclosed = proof_->carried(state);
  if (const auto* const factor = std::get_if<mpq_class>(&enclosed);
      factor != nullptr && *factor >= *statement_.lower)
    return {};
  const auto carried = carried_factor(exact_, state);
  if (!carried) return "the forces of the state are not in equilibrium within the yield forces";
  if (carried->factor < *statement_.lower) return "the state carries less than the claimed factor";
  return {};
}

}  // namespace kusabi::verify
