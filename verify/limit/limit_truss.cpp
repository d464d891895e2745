// Numbers of a certificate are exact.
#include "verify/limit/limit_truss.hpp"

namespace kusabi::verify {

LimitTruss recorded_truss(const LimitCertificate& certificate) {
  LimitTruss truss;
  for (const auto& column : certificate.columns) {
    auto& exact = truss.columns.emplace_back();
    for (const auto& [e, entry] : column) exact.emplace_back(e, Approximate{Dyadic(entry), {}});
  }
  for (const double dead : certificate.dead) truss.dead.push_back({Dyadic(dead), {}});
  for (const double reference : certificate.reference) {
    truss.reference.push_back({Dyadic(reference), {}});
  }
  truss.half_widths = certificate.alpha;
  return truss;
}

Dyadic elongation_of(const TrussColumn& column, const std::vector<Dyadic>& motion) {
  Dyadic total;
  for (const auto& [e, entry] : column) total = total + entry.value * motion[e];
  return total;
}

}  // namespace kusabi::verify
