// Shape functions, strains, stresses, as any book on finite elements has them.
#include "verify/plane_element.hpp"

namespace kusabi::verify {
namespace {

// (strain xx, strain yy, shear xy) to stress: normal on the diagonal, across off it, and shear.
struct Elasticity {
  Enclosure normal;
  Enclosure across;
  Enclosure shear;
};

Elasticity elasticity(const PlaneElement& element) {
  const Enclosure one(1);
  const Enclosure two(2);
  const Enclosure modulus(element.modulus);
  const Enclosure ratio(element.ratio);
  const auto shear = modulus / (two * (one + ratio));
  if (element.plane_strain) {
    const auto common = modulus / ((one + ratio) * (one - two * ratio));
    return {common * (one - ratio), common * ratio, shear};
  }
  const auto common = modulus / (one - ratio * ratio);
  return {common, common * ratio, shear};
}

// Of the four shape functions along x and y at one Gauss point, and the area it stands for.
struct Slopes {
  std::array<std::array<Enclosure, 2>, 4> gradient;
  Enclosure area;
};

constexpr std::array<int, 4> sides{-1, 1, 1, -1};
constexpr std::array<int, 4> ends{-1, -1, 1, 1};

Slopes slopes_at(const Structure& structure, const PlaneElement& element, std::size_t point) {
  const auto gauss = Enclosure(1) / sqrt(Enclosure(3));
  const auto xi = gauss * Enclosure(sides[point]);
  const auto eta = gauss * Enclosure(ends[point]);
  const Enclosure quarter(0.25);
  std::array<std::array<Enclosure, 2>, 4> natural;  // along xi and eta
  std::array<std::array<Enclosure, 2>, 2> jacobian;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const Enclosure side(sides[corner]);
    const Enclosure end(ends[corner]);
    natural[corner] = {quarter * side * (Enclosure(1) + end * eta),
                       quarter * end * (Enclosure(1) + side * xi)};
    const auto& place = structure.places[element.nodes[corner]];
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        jacobian[k][axis] += natural[corner][k] * Enclosure(place[axis]);
      }
    }
  }
  const auto determinant = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
  Slopes result;
  result.area = magnitude(determinant);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const auto& [along_xi, along_eta] = natural[corner];
    result.gradient[corner] = {
        (jacobian[1][1] * along_xi - jacobian[0][1] * along_eta) / determinant,
        (jacobian[0][0] * along_eta - jacobian[1][0] * along_xi) / determinant};
  }
  return result;
}

}  // namespace

void add_element(const Structure& structure, const Freedom& freedom, const PlaneElement& element,
                 SparseEnclosure& matrix) {
  const auto [normal, across, shear] = elasticity(element);
  for (std::size_t point = 0; point < 4; ++point) {
    const auto [gradient, area] = slopes_at(structure, element, point);
    const auto weight = Enclosure(element.thickness) * area;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto x = weight * gradient[i][0];
      const auto y = weight * gradient[i][1];
      for (std::size_t j = 0; j < 4; ++j) {
        const auto& [dx, dy] = gradient[j];
        const std::array<std::array<Enclosure, 2>, 2> entries{
            {{normal * (x * dx) + shear * (y * dy), across * (x * dy) + shear * (y * dx)},
             {across * (y * dx) + shear * (x * dy), normal * (y * dy) + shear * (x * dx)}}};
        for (std::size_t k = 0; k < 2; ++k) {
          const auto row = freedom.number[element.nodes[i]][k];
          for (std::size_t l = 0; l < 2; ++l) {
            const auto column = freedom.number[element.nodes[j]][l];
            if (row == Freedom::none || column == Freedom::none) continue;
            matrix[row][column] += entries[k][l];
          }
        }
      }
    }
  }
}

}  // namespace kusabi::verify
