// A structure as its file describes it: bars and plane elements in its own units, its supports, the
// nodes that may touch an obstacle (Gamma_D, Gamma_N and Gamma_C of the wedged paper's section 2),
// and the loads (section 2.2 and 3.1 of the limit paper).
//
// Plain data. `read_structure` fills it from a file, a program may fill it by hand;
// `check_structure` says whether it can be computed with.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "support/input_error.hpp"

namespace kusabi::problems {

/// The user's units, only carried along: every answer is in these.
struct Units {
  std::string length;
  std::string force;
};

/// Largest axial forces of a bar that is perfectly plastic, both >= 0.
struct YieldForces {
  double tension = 0;
  double compression = 0;

  friend bool operator==(const YieldForces&, const YieldForces&) = default;
};

/// A bar between two nodes.
struct Member {
  int first;
  int second;
  double axial_stiffness = 0;          ///< E A, force; 0: not given, of no need to limit analysis
  std::optional<YieldForces> yield{};  ///< q^y; nothing: not given
};

/// A force at a node: part of f_D, or of f_R that the load factor multiplies (limit paper (3)).
struct Load {
  enum class Kind { dead, reference };
  Kind kind;
  int node;
  Eigen::VectorXd force;  ///< d
};

/// What a parameter of the dead load puts on one component.
struct UncertainComponent {
  int node;
  int axis;
  double weight = 1;  ///< not zero: the half-width for alpha = 1
};

/// A parameter zeta_j of the dead load, known up to +- alpha, and its column of T (limit paper (6),
/// (7)).
struct UncertainParameter {
  std::string name;  ///< empty: of a single component, which is its name, with a weight above zero
  std::vector<UncertainComponent> components;
};

/// How a plane element is held across the plane.
enum class PlaneState {
  stress,  ///< thin: free to become thinner, no stress across
  strain,  ///< long: no strain across
};

/// A four-node element of an isotropic body in the plane (Q4).
struct Quadrilateral {
  std::array<int, 4> nodes;  ///< going round, either way
  double modulus;            ///< E, force/length^2
  double ratio;              ///< nu, Poisson's ratio
  double thickness;          ///< length
  PlaneState state;
};

/// A node that lies on the surface of the rigid obstacle, without a gap.
struct ContactCandidate {
  int node;
  Eigen::VectorXd normal;  ///< d, unit, outward normal of the obstacle: u_n >= 0 is separation
  std::optional<Eigen::VectorXd> tangent;  ///< d, wish for the first tangent, any length
  double friction = 1;  ///< mu_i, relative to the coefficient that a search is asked for
  /// d, the normal before it was made a unit vector and rounded; nothing: `normal` is meant
  std::optional<Eigen::VectorXd> direction{};
};

/// Where in the file each entry stands, so that an error found late still names its line. A
/// structure made by a program leaves the vectors empty.
struct Sources {
  std::string file;
  std::vector<support::SourcePosition> nodes;              ///< one a node: its name
  std::vector<support::SourcePosition> members;            ///< one a member: its pair of nodes
  std::vector<support::SourcePosition> axial_stiffnesses;  ///< one a member: the EA of its group
  std::vector<support::SourcePosition> elements;   ///< one an element: its nodes, or its mesh
  std::vector<support::SourcePosition> materials;  ///< one an element: the head of its group
  std::vector<support::SourcePosition> yields;     ///< one a member: the yield of its group
  std::vector<support::SourcePosition> contact;    ///< one a candidate: its name in the list
  std::vector<support::SourcePosition> normals;    ///< one a candidate: the normal of its group
  std::vector<support::SourcePosition> tangents;   ///< one a candidate: the tangent of its group
  std::vector<support::SourcePosition> frictions;  ///< one a candidate: the friction of its group
  std::vector<support::SourcePosition> loads;      ///< one a load: its node in the list
  /// One a component, parameter by parameter: its node in the list.
  std::vector<support::SourcePosition> uncertain;
};

struct Structure {
  std::string name;
  int dimension = 0;  ///< d: 2 or 3
  Units units;
  std::vector<std::string> node_names;
  Eigen::MatrixXd coordinates;  ///< d x nodes, length
  std::vector<Member> members;
  std::vector<Quadrilateral> elements;     ///< only if d = 2; members and elements may be mixed
  std::vector<std::array<bool, 3>> fixed;  ///< per node, per axis; the third is unused if d = 2
  std::vector<ContactCandidate> contact;   ///< in the order of every answer
  std::vector<Load> loads;                 ///< in the order of the file
  /// Nothing: every free component that carries neither dead nor reference load, with weight 1.
  std::optional<std::vector<UncertainParameter>> uncertain;
  Sources sources;
};

/// "x", "y" or "z".
std::string_view axis_name(int axis);

/// An error about `structure`: names its file and `position`, or, without a file, the structure.
support::InputError structure_error(const Structure& structure, support::SourcePosition position,
                                    std::string_view message);

/// Entry `index` of `positions`, or no position when the structure has none.
support::SourcePosition position_of(const std::vector<support::SourcePosition>& positions,
                                    int index);

}  // namespace kusabi::problems
