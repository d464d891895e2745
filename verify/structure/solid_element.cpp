// Jacobians, gradients and stresses of isoparametric elements.
#include "verify/structure/solid_element.hpp"

#include "verify/structure/placed_nodes.hpp"
#include "verify/structure/reference_element.hpp"

namespace kusabi::verify {
namespace {

using Vector3 = std::array<Enclosure, 3>;

// Stress for unit strains: `normal` on the diagonal, `across` off the diagonal, and `shear` for an
// engineering shear strain of one.
struct Elasticity {
  Enclosure normal;
  Enclosure across;
  Enclosure shear;
};

Elasticity elasticity(const Element& element, std::size_t dimension) {
  const Enclosure one(1);
  const Enclosure two(2);
  const Enclosure modulus(element.modulus);
  const Enclosure ratio(element.ratio);
  const auto shear = modulus / (two * (one + ratio));
  if (dimension == 3 || element.plane_strain) {
    const auto common = modulus / ((one + ratio) * (one - two * ratio));
    return {common * (one - ratio), common * ratio, shear};
  }
  const auto common = modulus / (one - ratio * ratio);
  return {common, common * ratio, shear};
}

// J_kl, the derivative of coordinate l along natural coordinate k; coordinates are relative to the
// first node.
std::array<Vector3, 3> jacobian(const Structure& structure, const Element& element,
                                const ReferencePoint& point) {
  const auto d = structure.dimension;
  std::array<Vector3, 3> matrix;
  for (std::size_t node = 1; node < element.nodes.size(); ++node) {
    for (std::size_t l = 0; l < d; ++l) {
      const auto along = coordinate(structure, element.nodes[node], l) -
                         coordinate(structure, element.nodes.front(), l);
      for (std::size_t k = 0; k < d; ++k) matrix[k][l].add_product(point.slopes[node][k], along);
    }
  }
  if (d == 2) matrix[2][2] = Enclosure(1);
  return matrix;
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Gradients of the shape functions along x, y, z at an integration point, and its volume.
struct Gradients {
  std::vector<Vector3> of_node;
  Enclosure volume;
};

Gradients gradients(const Structure& structure, const Element& element,
                    const ReferencePoint& point) {
  const auto d = structure.dimension;
  const auto j = jacobian(structure, element, point);
  // Columns of the inverse, times the determinant.
  std::array<Vector3, 3> dual{cross(j[1], j[2]), cross(j[2], j[0]), cross(j[0], j[1])};
  const auto determinant = j[0][0] * dual[0][0] + j[0][1] * dual[0][1] + j[0][2] * dual[0][2];
  for (auto& column : dual) {
    for (auto& component : column) component = component / determinant;
  }
  Gradients result;
  result.volume = point.weight * magnitude(determinant);
  result.of_node.resize(element.nodes.size());
  for (std::size_t node = 0; node < element.nodes.size(); ++node) {
    for (std::size_t l = 0; l < d; ++l) {
      for (std::size_t k = 0; k < d; ++k)
        result.of_node[node][l].add_product(dual[k][l], point.slopes[node][k]);
    }
  }
  return result;
}

// Integrals of products of gradient components, for nodes i, j <= i and axes k, l.
using Products = std::vector<std::vector<std::array<Vector3, 3>>>;

Products integrated_products(const Structure& structure, const Element& element) {
  const auto d = structure.dimension;
  Products products(element.nodes.size());
  for (std::size_t i = 0; i < products.size(); ++i) products[i].resize(i + 1);
  for (const auto& point : reference_points(d, element.nodes.size())) {
    const auto [gradient, volume] = gradients(structure, element, point);
    for (std::size_t i = 0; i < products.size(); ++i) {
      for (std::size_t k = 0; k < d; ++k) {
        const auto weighted = volume * gradient[i][k];
        for (std::size_t j = 0; j <= i; ++j) {
          for (std::size_t l = 0; l < d; ++l)
            products[i][j][k][l].add_product(weighted, gradient[j][l]);
        }
      }
    }
  }
  return products;
}

}  // namespace

void add_element(const Structure& structure, const Freedom& freedom, const Element& element,
                 SparseEnclosure& matrix) {
  const auto d = structure.dimension;
  auto [normal, across, shear] = elasticity(element, d);
  if (d == 2) {
    const Enclosure thickness(element.thickness);
    normal = normal * thickness;
    across = across * thickness;
    shear = shear * thickness;
  }
  const auto products = integrated_products(structure, element);
  const auto add = [&](std::size_t i, std::size_t k, std::size_t j, std::size_t l,
                       const Enclosure& entry) {
    freedom.add({element.nodes[i], k}, {element.nodes[j], l}, entry, matrix);
  };
  for (std::size_t i = 0; i < products.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const auto& product = products[i][j];
      for (std::size_t k = 0; k < d; ++k) {
        for (std::size_t l = 0; l < d; ++l) {
          Enclosure entry;  // force at i along k for a unit displacement at j along l
          if (k == l) {
            entry = normal * product[k][k];
            for (std::size_t other = 0; other < d; ++other) {
              if (other != k) entry.add_product(shear, product[other][other]);
            }
          } else {
            entry = across * product[k][l] + shear * product[l][k];
          }
          add(i, k, j, l, entry);
          if (i != j) add(j, l, i, k, entry);
        }
      }
    }
  }
}

}  // namespace kusabi::verify
