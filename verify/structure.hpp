// A structure as a problem file gives it, in plain data: all that the stiffness at its contact
// candidates, or its limit load, is computed from. The numbers are meant exactly, as the doubles
// that they are. The command fills it from the file; how files are read is all that is shared with
// what is to be proved.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace kusabi::verify {

/// A point or a vector; the third component is zero in the plane.
using Vector = std::array<double, 3>;

/// A bar from one node to another.
struct Bar {
  std::size_t first = 0;
  std::size_t second = 0;
  double axial_stiffness = 0;  ///< E A, force
  double tension = 0;          ///< yield forces, of interest to limit analysis alone
  double compression = 0;
};

/// A four-node element in the plane, integrated at 2 x 2 Gauss points.
struct PlaneElement {
  std::array<std::size_t, 4> nodes{};  ///< going round, either way
  double modulus = 0;                  ///< E
  double ratio = 0;                    ///< nu
  double thickness = 0;
  bool plane_strain = false;  ///< otherwise plane stress
};

/// A node that may touch the obstacle.
struct ContactPoint {
  std::size_t node = 0;
  Vector normal{};                  ///< outward, any length but zero
  std::optional<Vector> tangent{};  ///< where t1 shall point, as far as it lies across the normal
  /// The axis whose projection across the normal is t1 if nothing is wished for, d = 3.
  std::size_t tangent_axis = 0;
  double friction = 1;  ///< relative to the coefficient of a search
};

/// A force on the nodes of a truss.
struct Force {
  std::size_t node = 0;
  Vector components{};
};

/// A component of a load that is known up to +- weight times alpha.
struct UncertainForce {
  std::size_t node = 0;
  std::size_t axis = 0;
  double weight = 1;
};

struct Structure {
  std::size_t dimension = 0;  ///< d: 2 or 3
  std::vector<std::string> names;
  std::vector<Vector> places;              ///< one a node
  std::vector<std::array<bool, 3>> fixed;  ///< one a node
  std::vector<Bar> bars;
  std::vector<PlaneElement> elements;
  std::vector<ContactPoint> contact;  ///< in the order of every answer
  std::vector<Force> dead;
  std::vector<Force> reference;
  /// Nothing: every free component without dead and reference load, with weight 1.
  /// Otherwise by parameter: all components of one grow together.
  std::optional<std::vector<std::vector<UncertainForce>>> uncertain;
};

/// The free displacements, node by node and axis by axis.
struct Freedom {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t count = 0;
  std::vector<std::array<std::size_t, 3>> number;  ///< by node and axis; `none` if fixed

  explicit Freedom(const Structure& structure);
};

}  // namespace kusabi::verify
