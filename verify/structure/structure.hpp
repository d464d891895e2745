// A structure as a problem file gives it, in plain data: all that the stiffness at its contact
// candidates, or its limit load, is computed from. The numbers are meant exactly, as the doubles
// that they are. The command fills it from the file; how files are read is all that is shared with
// what is to be proved.
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
  double tension = 0;          ///< yield forces, of interest to limit analysis alone
  double compression = 0;
};

/// An isoparametric element, fully integrated; its shape is told by the number of its nodes.
struct Element {
  std::vector<std::size_t> nodes;  ///< corners, then middles of edges (docs/problem-files.md)
  double modulus = 0;              ///< E
  double ratio = 0;                ///< nu
  double thickness = 0;            ///< in the plane only, like the next
  bool plane_strain = false;       ///< otherwise plane stress
};

/// A spring between a node and the ground.
struct GroundSpring {
  std::size_t node = 0;
  std::size_t axis = 0;
  double stiffness = 0;  ///< force/length
};

/// A symmetric stiffness that another program has computed.
struct GivenStiffness {
  /// What a row is: the displacement of a node along an axis, or an unknown that nothing else
  /// speaks of.
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
  std::vector<Entry> entries;  ///< of both triangles, those that are not zero
};

/// What part a node has in a displacement that is made of those of others.
struct Part {
  std::size_t node = 0;
  double weight = 1;
};

/// A node whose displacement is the sum of weight times those of others.
struct TiedNode {
  std::size_t node = 0;
  std::vector<Part> to;
};

/// A node of which the displacement u has u . direction = 0.
struct InclinedNode {
  std::size_t node = 0;
  Vector direction{};  ///< any length but zero
};

/// A node that may touch the obstacle, or another body.
struct ContactPoint {
  std::size_t node = 0;
  Vector normal{};                  ///< outward, any length but zero
  std::optional<Vector> tangent{};  ///< where t1 shall point, as far as it lies across the normal
  /// The axis whose projection across the normal is t1 if nothing is wished for, d = 3.
  std::size_t tangent_axis = 0;
  double friction = 1;  ///< relative to the coefficient of a search
  /// The place of the other body: displacements of the candidate are relative to the sum of
  /// weight times those of these nodes. Empty: a rigid obstacle.
  std::vector<Part> against{};
  std::string surface{};  ///< what the file calls what it touches, if anything
};

/// A force on the nodes of a truss.
struct Force {
  std::size_t node = 0;
  Vector components{};
};

/// A component of a load that is known up to +- weight times a half-width.
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
  std::vector<Element> elements;
  std::vector<TiedNode> ties;
  std::vector<InclinedNode> inclined;
  std::vector<ContactPoint> contact;  ///< in the order of every answer
  std::vector<Force> dead;
  std::vector<Force> reference;
  /// Nothing: every free component without dead and reference load, with weight 1.
  /// Otherwise by parameter: all components of one grow together.
  std::optional<std::vector<std::vector<UncertainForce>>> uncertain;
  /// By parameter, its half-width if the structure says it; all others are free. Empty: all are.
  std::vector<std::optional<double>> half_widths;
  /// By parameter, what its group is called, or else itself; empty: it has no name.
  std::vector<std::string> load_names;
  std::vector<GroundSpring> springs;
  std::vector<GivenStiffness> given;
};

/// What an answer calls a candidate: its node, and the one that is against it: "a|b"; "a|b+" if
/// that one, of the largest weight, has others beside it. Where the node is several candidates it
/// is "a@left" by their surfaces if all have different ones, else "a@1" by their order.
std::string name_of(const Structure& structure, std::size_t candidate);

/// The candidates at each node that has more than one, by node.
std::map<std::size_t, std::vector<std::size_t>> corners(const Structure& structure);

}  // namespace kusabi::verify
