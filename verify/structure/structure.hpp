// Structure as plain data: the input of the enclosed contact stiffness and of the exact limit load.
// All numbers are exact, as the doubles that they are. The command fills it from the problem file;
// the file reader is the only code shared with the search.
#pragma once

#include <array>
#include <cstddef>
#include <map>
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
  double tension = 0;          ///< yield forces, for limit analysis
  double compression = 0;
  double residual = 0;  ///< in compression after buckling; of a bar that is no strut, `compression`
};

/// An isoparametric element, fully integrated; the number of its nodes determines its shape.
struct Element {
  std::vector<std::size_t> nodes;  ///< vertices, then midpoints of edges (docs/problem-files.md)
  double modulus = 0;              ///< E
  double ratio = 0;                ///< nu
  double thickness = 0;            ///< in the plane only, as is plane_strain
  bool plane_strain = false;       ///< otherwise plane stress
};

/// A spring between a node and the ground.
struct GroundSpring {
  std::size_t node = 0;
  std::size_t axis = 0;
  double stiffness = 0;  ///< force/length
};

/// A symmetric stiffness computed by another program.
struct GivenStiffness {
  /// Meaning of a row: the displacement of a node along an axis, or an internal unknown.
  struct Row {
    std::optional<std::size_t> node;
    std::size_t axis = 0;
  };
  struct Entry {
    std::size_t row = 0;
    std::size_t column = 0;
    double value = 0;
  };
  std::vector<Row> rows;
  std::vector<Entry> entries;  ///< nonzero entries of both triangles
};

/// Weight of a node in a dependent displacement.
struct Part {
  std::size_t node = 0;
  double weight = 1;
};

/// A node of a multi-point constraint: its displacement is the sum of weight times those of master
/// nodes.
struct MultiPointConstraint {
  std::size_t node = 0;
  std::vector<Part> to;
};

/// A node with the support condition u . direction = 0.
struct InclinedNode {
  std::size_t node = 0;
  Vector direction{};  ///< any positive length
};

/// A node that may touch the obstacle, or another body.
struct ContactPoint {
  std::size_t node = 0;
  Vector normal{};                  ///< outward, any positive length
  std::optional<Vector> tangent{};  ///< t1 is its component orthogonal to the normal
  /// In space without `tangent`: the axis whose component orthogonal to the normal is t1.
  std::size_t tangent_axis = 0;
  double friction = 1;  ///< relative to the friction coefficient of a search
  /// The opposite place on another body: displacements of the candidate are relative to the sum of
  /// weight times those of these nodes. Empty: a rigid obstacle.
  std::vector<Part> against{};
  std::string surface{};  ///< name of the opposite surface in the file, or empty
  double clearance = 0;   ///< u_n + clearance >= 0 under load
};

/// A force on the nodes of a truss.
struct Force {
  std::size_t node = 0;
  Vector components{};
};

/// A load component that varies by up to weight times a half-width.
struct UncertainForce {
  std::size_t node = 0;
  std::size_t axis = 0;
  double weight = 1;
};

struct Structure {
  std::size_t dimension = 0;  ///< d: 2 or 3
  std::vector<std::string> names;
  std::vector<Vector> coordinates;         ///< one for each node
  std::vector<std::array<bool, 3>> fixed;  ///< one for each node
  std::vector<Bar> bars;
  std::vector<Element> elements;
  std::vector<MultiPointConstraint> ties;
  std::vector<InclinedNode> inclined;
  std::vector<ContactPoint> contact;  ///< in the order of all answers
  std::vector<Force> dead;
  std::vector<Force> reference;
  /// By parameter: the components that vary together. Nothing: every free component without dead
  /// and reference load is a parameter of weight 1.
  std::optional<std::vector<std::vector<UncertainForce>>> uncertain;
  /// By parameter, its half-width if the structure specifies it. Empty: none is specified.
  std::vector<std::optional<double>> half_widths;
  /// By parameter, the name of its group or its own; empty: it has no name.
  std::vector<std::string> load_names;
  std::vector<GroundSpring> springs;
  std::vector<GivenStiffness> given;
};

/// Name of a candidate in answers: its node and the opposite one, "a|b"; "a|b+" if b, the node of
/// the largest weight, is one of several. Candidates at the same node are "a@left" by their
/// surfaces if these differ, otherwise "a@1" by their order.
std::string name_of(const Structure& structure, std::size_t candidate);

/// The candidates at each node with more than one, by node.
std::map<std::size_t, std::vector<std::size_t>> shared_nodes(const Structure& structure);

}  // namespace kusabi::verify
