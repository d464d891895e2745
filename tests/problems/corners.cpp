// Candidates of random bodies at other places.
#include "corners.hpp"

#include <utility>
#include <vector>

#include "bodies.hpp"
#include "dense.hpp"
#include "trusses.hpp"

namespace kusabi::problems::test {

std::vector<Eigen::VectorXd> random_normals(int dimension, int count, std::mt19937& bits) {
  for (;;) {
    Eigen::MatrixXd normals(dimension, count);
    std::vector<Eigen::VectorXd> result;
    for (int k = 0; k < count; ++k) {
      result.emplace_back(random_vector(dimension, bits).normalized());
      normals.col(k) = result.back();
    }
    const Eigen::MatrixXd cosines = normals.transpose() * normals;
    // The least singular value of the normals is above 0.3.
    const Eigen::MatrixXd gram =
        count > dimension ? Eigen::MatrixXd(normals * normals.transpose()) : cosines;
    if (cosines.minCoeff() >= 0 && dense::eigenvalues(gram)(0) > 0.09) return result;
  }
}

Structure random_corners(int dimension, std::mt19937& bits) {
  Structure structure = random_bodies(dimension, bits);
  structure.contact.clear();
  const auto a = [&](int i) { return dimension + i; };
  const auto b = [&](int i) { return dimension + 5 + dimension + i; };
  const auto touches = [&](int node, Eigen::VectorXd normal, std::vector<WeightedNode> place) {
    structure.contact.push_back(
        {node, std::move(normal), std::nullopt, 1, std::nullopt, std::move(place)});
  };
  const int walls = dimension == 3 && bits() % 2 == 0 ? 3 : 2;
  const auto in_corner = random_normals(dimension, walls, bits);
  const auto against = random_normals(dimension, 2, bits);
  const auto between = random_normals(dimension, 2, bits);
  const auto led = random_normals(dimension, 2, bits);
  for (const auto& normal : in_corner) touches(a(0), normal, {});
  touches(a(1), against[0], {{b(1), 0.3}, {b(2), 0.7}});
  touches(a(2), between[0], {{b(0), 0.25}, {b(3), 0.75}});
  touches(b(3), led[0], {});
  touches(a(1), against[1], {});
  touches(b(3), led[1], {});
  touches(a(2), between[1], {{b(2), 1}});
  const Eigen::VectorXd x = Eigen::VectorXd::Unit(dimension, 0);
  if (dimension == 3) {
    touches(a(3), x, {});
    touches(a(3), Eigen::Vector3d(0.28, 0, 0.96), {});
  } else {
    structure.contact.push_back({a(3), x, Eigen::VectorXd::Unit(2, 1), 1, std::nullopt, {}});
  }
  return structure;
}

}  // namespace kusabi::problems::test
