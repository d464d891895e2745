// Jacobians, gradients, and the sums over the integration points.
#include "problems/structure/assembly/solid_element.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "problems/structure/assembly/shape_functions.hpp"

namespace kusabi::problems {
namespace {

template <std::size_t D, class Scalar>
using Vector = std::array<Scalar, D>;

/// Coordinates relative to the first node, which avoids cancellation far from the origin.
template <std::size_t D, class Scalar>
std::vector<Vector<D, Scalar>> places_of(const Structure& structure, const Element& element) {
  std::vector<Vector<D, Scalar>> places(element.nodes.size());
  const auto first = structure.coordinates.col(element.nodes.front());
  for (std::size_t node = 0; node < places.size(); ++node) {
    const auto place = structure.coordinates.col(element.nodes[node]);
    for (std::size_t k = 0; k < D; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      places[node][k] = numbers::difference<Scalar>(place(axis), first(axis));
    }
  }
  return places;
}

/// J, its determinant and cofactors: J^-1 = C^T / det J.
template <std::size_t D, class Scalar>
struct Jacobian {
  std::array<Vector<D, Scalar>, D> cofactors;  ///< C_kl = d det J / d J_kl
  Scalar determinant;
};

/// J_kl = d x_l / d xi_k.
template <std::size_t D, class Scalar>
Jacobian<D, Scalar> jacobian(const std::vector<Vector<D, Scalar>>& places,
                             const NaturalSlopes<Scalar>& slopes) {
  std::array<Vector<D, Scalar>, D> matrix;
  for (std::size_t k = 0; k < D; ++k) {
    for (std::size_t l = 0; l < D; ++l) {
      matrix[k][l] = 0.0;
      // The first node has zero coordinates.
      for (std::size_t a = 1; a < places.size(); ++a) matrix[k][l] += slopes[a][k] * places[a][l];
    }
  }
  Jacobian<D, Scalar> result;
  auto& c = result.cofactors;
  if constexpr (D == 2) {
    c = {{{matrix[1][1], -matrix[1][0]}, {-matrix[0][1], matrix[0][0]}}};
  } else {
    for (std::size_t k = 0; k < D; ++k) {
      const auto& next = matrix[(k + 1) % D];
      const auto& last = matrix[(k + 2) % D];
      for (std::size_t l = 0; l < D; ++l)
        c[k][l] = next[(l + 1) % D] * last[(l + 2) % D] - next[(l + 2) % D] * last[(l + 1) % D];
    }
  }
  result.determinant = 0.0;
  for (std::size_t l = 0; l < D; ++l) result.determinant += matrix[0][l] * c[0][l];
  return result;
}

/// det J times the gradients of the shape functions along x, y, z.
template <std::size_t D, class Scalar>
void gradients_at(const Jacobian<D, Scalar>& jacobian, const NaturalSlopes<Scalar>& slopes,
                  std::vector<Vector<D, Scalar>>& gradients) {
  gradients.resize(slopes.size());
  for (std::size_t a = 0; a < slopes.size(); ++a) {
    for (std::size_t l = 0; l < D; ++l) {
      gradients[a][l] = jacobian.cofactors[0][l] * slopes[a][0];
      for (std::size_t k = 1; k < D; ++k)
        gradients[a][l] += jacobian.cofactors[k][l] * slopes[a][k];
    }
  }
}

template <class Scalar>
struct Lame {
  Scalar lambda;
  Scalar mu;
};

/// Times the thickness in the plane.
template <class Scalar>
Lame<Scalar> lame(const Element& element) {
  const Scalar one = 1.0;
  const Scalar two = 2.0;
  const Scalar modulus = element.modulus;
  const Scalar ratio = element.ratio;
  const bool in_space = shape_traits(element.shape).dimension == 3;
  const bool thin = !in_space && element.state == PlaneState::stress;
  const Scalar thickness = in_space ? 1.0 : element.thickness;
  const Scalar mu = thickness * modulus / (two * (one + ratio));
  return {two * mu * ratio / (thin ? one - ratio : one - two * ratio), mu};
}

template <std::size_t D, class Scalar>
using Block = std::array<Scalar, D * D>;

/// H_ab for b <= a, in this order.
template <std::size_t D, class Scalar>
std::vector<Block<D, Scalar>> gradient_products(const Structure& structure,
                                                const Element& element) {
  using std::abs;
  const auto places = places_of<D, Scalar>(structure, element);
  const auto size = places.size();
  Block<D, Scalar> zero;
  zero.fill(0.0);
  std::vector<Block<D, Scalar>> products(size * (size + 1) / 2, zero);
  std::vector<Vector<D, Scalar>> gradients;
  for (const auto& point : integration_points<Scalar>(element.shape)) {
    const auto local = jacobian<D, Scalar>(places, point.slopes);
    gradients_at(local, point.slopes, gradients);
    const Scalar weight = point.weight / abs(local.determinant);
    auto block = products.begin();
    for (std::size_t a = 0; a < size; ++a) {
      auto weighted = gradients[a];
      for (auto& component : weighted) component *= weight;
      for (std::size_t b = 0; b <= a; ++b, ++block) {
        for (std::size_t k = 0; k < D; ++k) {
          for (std::size_t l = 0; l < D; ++l) (*block)[D * k + l] += weighted[k] * gradients[b][l];
        }
      }
    }
  }
  return products;
}

template <std::size_t D, class Scalar>
ElementMatrix<Scalar> matrix_of(const Structure& structure, const Element& element,
                                const Lame<Scalar>& material) {
  const auto products = gradient_products<D, Scalar>(structure, element);
  const auto size = static_cast<Eigen::Index>(D * element.nodes.size());
  ElementMatrix<Scalar> matrix(size, size);
  auto block = products.begin();
  for (std::size_t a = 0; a < element.nodes.size(); ++a) {
    for (std::size_t b = 0; b <= a; ++b, ++block) {
      Scalar trace = (*block)[0];
      for (std::size_t k = 1; k < D; ++k) trace += (*block)[D * k + k];
      trace *= material.mu;
      for (std::size_t k = 0; k < D; ++k) {
        const auto row = static_cast<Eigen::Index>(D * a + k);
        for (std::size_t l = 0; l < D; ++l) {
          const auto column = static_cast<Eigen::Index>(D * b + l);
          if (column > row) continue;
          Scalar entry = material.lambda * (*block)[D * k + l] + material.mu * (*block)[D * l + k];
          if (k == l) entry += trace;
          matrix(row, column) = matrix(column, row) = entry;
        }
      }
    }
  }
  return matrix;
}

template <std::size_t D>
std::vector<StrainVector<double>> vectors_of(const Structure& structure, const FreeDegrees& degrees,
                                             const Element& element, double scale) {
  const auto places = places_of<D, double>(structure, element);
  std::vector<Vector<D, double>> gradients;
  std::vector<StrainVector<double>> vectors;
  for (const auto& point : integration_points<double>(element.shape)) {
    const auto local = jacobian<D, double>(places, point.slopes);
    gradients_at(local, point.slopes, gradients);
    const double weight = std::sqrt(scale * point.weight / std::abs(local.determinant));
    for (std::size_t k = 0; k < D; ++k) {
      for (std::size_t l = 0; l <= k; ++l) {  // e_kk, and sqrt(2) e_kl for both e_kl and e_lk
        const double part = k == l ? weight : weight * std::sqrt(0.5);
        StrainVector<double> vector;
        for (std::size_t a = 0; a < gradients.size(); ++a) {
          const int node = element.nodes[a];
          add_entry(degrees, static_cast<int>(k), node, part * gradients[a][l], vector);
          if (k == l) continue;
          add_entry(degrees, static_cast<int>(l), node, part * gradients[a][k], vector);
        }
        vectors.push_back(std::move(vector));
      }
    }
  }
  return vectors;
}

template <std::size_t D>
Eigen::VectorXd determinants_of(const Structure& structure, const Element& element) {
  const auto& traits = shape_traits(element.shape);
  const auto places = places_of<D, double>(structure, element);
  const double factor = traits.family == ShapeFamily::simplex   ? 1
                        : traits.family == ShapeFamily::prism   ? 2
                        : traits.family == ShapeFamily::pyramid ? 4
                                                                : std::exp2(D);
  std::vector<double> values;
  for (int vertex = 0; vertex < traits.vertices; ++vertex) {
    auto at = traits.nodes[static_cast<std::size_t>(vertex)];
    // In a pyramid det J is zeta^2 times a bilinear function of xi and eta: at the apex that of the
    // centre of the base.
    if (traits.family == ShapeFamily::pyramid) at[2] = -1;
    const auto slopes = natural_slopes(element.shape, at);
    values.push_back(factor * jacobian<D, double>(places, slopes).determinant);
  }
  for (const auto& point : integration_points<double>(element.shape))
    values.push_back(factor * jacobian<D, double>(places, point.slopes).determinant);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

template <class Scalar>
ElementMatrix<Scalar> element_matrix(const Structure& structure, const Element& element) {
  const auto material = lame<Scalar>(element);
  return structure.dimension == 2 ? matrix_of<2, Scalar>(structure, element, material)
                                  : matrix_of<3, Scalar>(structure, element, material);
}

template ElementMatrix<double> element_matrix(const Structure&, const Element&);
template ElementMatrix<numbers::Precise> element_matrix(const Structure&, const Element&);
template ElementMatrix<numbers::RunningError> element_matrix(const Structure&, const Element&);

std::vector<StrainVector<double>> shape_vectors(const Structure& structure,
                                                const FreeDegrees& degrees,
                                                const Element& element) {
  if (structure.dimension == 2) return vectors_of<2>(structure, degrees, element, 1);
  return vectors_of<3>(structure, degrees, element, 1 / element_extent(structure, element));
}

ElementMatrix<double> shape_matrix(const Structure& structure, const Element& element) {
  const Lame<double> unit{0, 0.5};
  if (structure.dimension == 2) return matrix_of<2, double>(structure, element, unit);
  return matrix_of<3, double>(structure, element, unit) / element_extent(structure, element);
}

double element_extent(const Structure& structure, const Element& element) {
  double extent = 0;
  for (const int node : element.nodes) {
    extent = std::max(
        extent, (structure.coordinates.col(node) - structure.coordinates.col(element.nodes.front()))
                    .norm());
  }
  return extent;
}

Eigen::VectorXd jacobian_determinants(const Structure& structure, const Element& element) {
  return structure.dimension == 2 ? determinants_of<2>(structure, element)
                                  : determinants_of<3>(structure, element);
}

Eigen::SparseMatrix<double> element_stiffness(const Structure& structure,
                                              const FreeDegrees& degrees) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Element& element : structure.elements) {
    add_matrix(element_matrix<double>(structure, element), element_parts<double>(degrees, element),
               entries);
  }
  Eigen::SparseMatrix<double> stiffness(degrees.size(), degrees.size());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

}  // namespace kusabi::problems
