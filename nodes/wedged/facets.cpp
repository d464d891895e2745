// Polyhedral friction cones as sums of plane ones.
#include "nodes/wedged/facets.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace kusabi::wedged {
namespace {

int checked(int facets) {
  if (facets < FacetBound::fewest || facets > FacetBound::most || facets % 2 != 0) {
    throw std::invalid_argument(
        fmt::format("a friction cone takes an even number of facets from {} to {}, not {}",
                    FacetBound::fewest, FacetBound::most, facets));
  }
  return facets;
}

conic::NodeSolver<2> solver_of(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                               int facets, conic::Tolerances tolerances, double error) {
  const auto m = static_cast<Eigen::Index>(friction.size());
  if (compliance.rows() != 3 * m || compliance.cols() != 3 * m)
    throw std::invalid_argument("polyhedral friction is for contact in space");
  const int each = facets / 2;
  // Row 2k of `spread` is the normal of cone k, row 2k + 1 its tangent, both as displacements of
  // its candidate: the cones have the compliance spread F spread'.
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(2 * each * m, 3 * m);
  std::vector<double> widened;
  std::vector<int> owners;
  for (Eigen::Index i = 0; i < m; ++i) {
    for (int k = 0; k < each; ++k) {
      const double angle = std::numbers::pi * (2 * k + 1) / facets;
      const Eigen::Index row = 2 * (each * i + k);
      spread(row, 3 * i) = 1;
      spread(row + 1, 3 * i + 1) = std::cos(angle);
      spread(row + 1, 3 * i + 2) = std::sin(angle);
      widened.push_back(friction[static_cast<std::size_t>(i)] /
                        std::cos(std::numbers::pi / facets));
      owners.push_back(static_cast<int>(i));
    }
  }
  const Eigen::MatrixXd product = spread * compliance * spread.transpose();
  // The roundings of the spread and of the products come on top of what F is wrong by.
  constexpr double spread_roundings = 32 * 0x1p-53;
  return {0.5 * (product + product.transpose()), widened, std::move(owners), tolerances,
          error + spread_roundings};
}

}  // namespace

FacetBound::FacetBound(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                       int facets, conic::Tolerances tolerances, double error)
    : cones_each_(checked(facets) / 2),
      solver_(solver_of(compliance, friction, facets, tolerances, error)) {}

conic::Answer FacetBound::solve(std::uint64_t contact, std::uint64_t separated,
                                conic::StopEarly stop, std::uint64_t ignored) {
  return solver_.solve(contact, separated, stop, ignored);
}

double FacetBound::normal_reaction(int candidate) const {
  double sum = 0;
  for (int k = 0; k < cones_each_; ++k)
    sum += solver_.reaction()[2 * (Eigen::Index{cones_each_} * candidate + k)];
  return sum;
}

double FacetBound::normal_displacement(int candidate) const {
  return solver_.displacement()[2 * Eigen::Index{cones_each_} * candidate];
}

}  // namespace kusabi::wedged
