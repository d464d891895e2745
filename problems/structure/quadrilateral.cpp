// Shape functions, the strain-displacement matrix and the square root of the elasticity matrix.
#include "problems/structure/quadrilateral.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace kusabi::problems {
namespace {

constexpr std::array<int, 4> corner_xi{-1, 1, 1, -1};
constexpr std::array<int, 4> corner_eta{-1, -1, 1, 1};

/// Relates (strain xx, strain yy, shear xy) to stress.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> elasticity(Scalar modulus, Scalar ratio, PlaneState state) {
  Eigen::Matrix<Scalar, 3, 3> matrix;
  if (state == PlaneState::stress) {
    matrix << 1, ratio, 0, ratio, 1, 0, 0, 0, (1 - ratio) / 2;
    return modulus / (1 - ratio * ratio) * matrix;
  }
  matrix << 1 - ratio, ratio, 0, ratio, 1 - ratio, 0, 0, 0, (1 - 2 * ratio) / 2;
  return modulus / ((1 + ratio) * (1 - 2 * ratio)) * matrix;
}

template <class Scalar>
Eigen::Matrix<Scalar, 4, 2> corners(const Structure& structure, const Quadrilateral& element) {
  Eigen::Matrix<Scalar, 4, 2> places;
  for (int corner = 0; corner < 4; ++corner) {
    const int node = element.nodes[static_cast<std::size_t>(corner)];
    places.row(corner) = structure.coordinates.col(node).head<2>().cast<Scalar>().transpose();
  }
  return places;
}

template <class Scalar>
std::vector<StrainVector<Scalar>> vectors(const Structure& structure, const FreeDegrees& degrees,
                                          const Quadrilateral& element,
                                          const Eigen::Matrix<Scalar, 3, 3>& stress_of_strain) {
  using std::abs;
  using std::sqrt;
  const Eigen::Matrix<Scalar, 4, 2> places = corners<Scalar>(structure, element);
  const Eigen::Matrix<Scalar, 3, 3> root =
      Eigen::LLT<Eigen::Matrix<Scalar, 3, 3>>(stress_of_strain).matrixU();
  const Scalar gauss = 1 / sqrt(Scalar(3));
  std::vector<StrainVector<Scalar>> result;
  for (int point = 0; point < 4; ++point) {
    const auto at = static_cast<std::size_t>(point);
    const Scalar xi = gauss * corner_xi[at];
    const Scalar eta = gauss * corner_eta[at];
    Eigen::Matrix<Scalar, 2, 4> slopes;  // of the shape functions along xi, eta
    for (int corner = 0; corner < 4; ++corner) {
      const Scalar side = corner_xi[static_cast<std::size_t>(corner)];
      const Scalar end = corner_eta[static_cast<std::size_t>(corner)];
      slopes.col(corner) << side * (1 + end * eta) / 4, end * (1 + side * xi) / 4;
    }
    const Eigen::Matrix<Scalar, 2, 2> jacobian = slopes * places;
    const Eigen::Matrix<Scalar, 2, 4> gradients = jacobian.inverse() * slopes;  // along x, y
    const Scalar weight = sqrt(abs(jacobian.determinant()));
    for (int row = 0; row < 3; ++row) {
      StrainVector<Scalar> vector;
      for (int corner = 0; corner < 4; ++corner) {
        const int node = element.nodes[static_cast<std::size_t>(corner)];
        const Scalar dx = gradients(0, corner);
        const Scalar dy = gradients(1, corner);
        const std::array<Scalar, 2> values{weight * (root(row, 0) * dx + root(row, 2) * dy),
                                           weight * (root(row, 1) * dy + root(row, 2) * dx)};
        for (int axis = 0; axis < 2; ++axis) {
          const int number = degrees.number(axis, node);
          if (number >= 0) vector.push_back({number, values[static_cast<std::size_t>(axis)]});
        }
      }
      result.push_back(std::move(vector));
    }
  }
  return result;
}

}  // namespace

template <class Scalar>
std::vector<StrainVector<Scalar>> strain_vectors(const Structure& structure,
                                                 const FreeDegrees& degrees,
                                                 const Quadrilateral& element) {
  const Eigen::Matrix<Scalar, 3, 3> matrix =
      Scalar(element.thickness) *
      elasticity<Scalar>(Scalar(element.modulus), Scalar(element.ratio), element.state);
  return vectors<Scalar>(structure, degrees, element, matrix);
}

template std::vector<StrainVector<double>> strain_vectors(const Structure&, const FreeDegrees&,
                                                          const Quadrilateral&);
template std::vector<StrainVector<numbers::Precise>> strain_vectors(const Structure&,
                                                                    const FreeDegrees&,
                                                                    const Quadrilateral&);

std::vector<StrainVector<double>> shape_vectors(const Structure& structure,
                                                const FreeDegrees& degrees,
                                                const Quadrilateral& element) {
  return vectors<double>(structure, degrees, element, elasticity(1.0, 0.0, PlaneState::stress));
}

Eigen::Vector4d corner_areas(const Structure& structure, const Quadrilateral& element) {
  const Eigen::Matrix<double, 4, 2> places = corners<double>(structure, element);
  Eigen::Vector4d areas;
  for (int corner = 0; corner < 4; ++corner) {
    const Eigen::RowVector2d ahead = places.row((corner + 1) % 4) - places.row(corner);
    const Eigen::RowVector2d back = places.row((corner + 3) % 4) - places.row(corner);
    areas(corner) = ahead(0) * back(1) - ahead(1) * back(0);
  }
  return areas;
}

Eigen::SparseMatrix<double> element_stiffness(const Structure& structure,
                                              const FreeDegrees& degrees) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Quadrilateral& element : structure.elements) {
    for (const auto& vector : strain_vectors<double>(structure, degrees, element)) {
      add_square(vector, 1.0, entries);
    }
  }
  Eigen::SparseMatrix<double> stiffness(degrees.size(), degrees.size());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

}  // namespace kusabi::problems
