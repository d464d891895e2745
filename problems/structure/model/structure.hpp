// A structure as its file describes it: bars and plane elements in its own units, its supports, the
// nodes that may touch an obstacle (Gamma_D, Gamma_N and Gamma_C of the wedged paper's section 2),
// and the loads (section 2.2 and 3.1 of the limit paper).
//
// Plain data. `read_structure` fills it from a file, a program may fill it by hand;
// `check_structure` says whether it can be computed with.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

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
  Eigen::VectorXd force;    ///< d
  std::string load_case{};  ///< empty: it is of all cases
};

/// What a parameter of the dead load puts on one component.
struct UncertainComponent {
  int node;
  int axis;
  double weight = 1;  ///< not zero: the half-width for alpha = 1
};

/// A parameter zeta_j of the dead load, known up to its half-width, and its column of T (limit
/// paper (6), (7)).
struct UncertainParameter {
  std::string name;  ///< empty: of a single component, which is its name, with a weight above zero
  std::vector<UncertainComponent> components;
  std::optional<double> half_width{};  ///< of zeta_j, force; nothing: the alpha that is asked for
  std::string group{};                 ///< what the file calls those that it is of; may be empty
  std::string load_case{};             ///< empty: it is of all cases
};

/// How a plane element is held across the plane.
enum class PlaneState {
  stress,  ///< thin: free to become thinner, no stress across
  strain,  ///< long: no strain across
};

/// Which element: how many nodes, and in which order (docs/problem-files.md).
enum class ElementShape {
  triangle3,
  triangle6,
  quadrilateral4,
  quadrilateral8,
  tetrahedron4,
  tetrahedron10,
  hexahedron8,
  hexahedron20,
};

/// An element of an isotropic body, in the plane or in space.
struct Element {
  std::vector<int> nodes;  ///< corners first, going round; in the order of its shape
  double modulus;          ///< E, force/length^2
  double ratio;            ///< nu, Poisson's ratio
  double thickness;        ///< length; of no meaning in space, like the next
  PlaneState state;
  ElementShape shape = ElementShape::quadrilateral4;
};

/// A spring between a node and the ground along one axis.
struct Spring {
  int node;
  int axis;
  double stiffness;  ///< > 0, force/length
};

/// What a row of a superelement speaks of: the displacement of a node along an axis, or an unknown
/// of its own, as a rotation, of which no support and no contact knows.
struct SuperelementRow {
  int node = -1;  ///< -1: an unknown of its own
  int axis = 0;
};

/// A body, or several, whose stiffness another program has computed.
struct Superelement {
  std::vector<SuperelementRow> rows;      ///< each displacement of a node at most once
  Eigen::SparseMatrix<double> stiffness;  ///< both triangles, force/length; meant exactly
  /// What each number may be off by, relative to itself, for it was written with so few digits. No
  /// answer takes that in, but what holds a body by less than this does not hold it.
  double rounding = 0;
};

/// A share that a node has in the place that a contact candidate touches, or another node is tied
/// to.
struct Share {
  int node;
  double weight;
};

/// A node without a will of its own: its displacement is the sum of weight times those of others.
struct Tie {
  int node;
  std::vector<Share> to;
};

/// A support that is no axis: the displacement u of its node has u . direction = 0.
struct InclinedSupport {
  int node;
  Eigen::VectorXd direction;  ///< d, any length but zero
};

/// A node that lies on the surface of the rigid obstacle, or of another body, without a gap.
struct ContactCandidate {
  int node;
  Eigen::VectorXd normal;  ///< d, unit, outward normal of the obstacle: u_n >= 0 is separation
  std::optional<Eigen::VectorXd> tangent;  ///< d, wish for the first tangent, any length
  double friction = 1;  ///< mu_i, relative to the coefficient that a search is asked for
  /// d, the normal before it was made a unit vector and rounded; nothing: `normal` is meant
  std::optional<Eigen::VectorXd> direction{};
  /// The place of the other body: its displacement is the sum of weight times that of the node.
  /// Empty: the obstacle is rigid. The displacement of the candidate is that of `node` less this,
  /// and the reaction acts on both, with opposite signs.
  std::vector<Share> against{};
  /// What the file calls what the candidate touches; of use where a node is more than one
  /// candidate.
  std::string surface{};
};

/// Where in the file each entry stands, so that an error found late still names its line. A
/// structure made by a program leaves the vectors empty.
struct Sources {
  std::string file;
  std::vector<std::string> more_files;           ///< `SourcePosition::file` counts them from 1
  std::vector<support::SourcePosition> nodes;    ///< one a node: its name
  std::vector<support::SourcePosition> members;  ///< one a member: its pair of nodes
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
  std::vector<support::SourcePosition> superelements;  ///< one a superelement: its file
  std::vector<support::SourcePosition> springs;        ///< one a spring: its node in the list
  std::vector<support::SourcePosition> ties;           ///< one a tie: its node in the list
  std::vector<support::SourcePosition> inclined;       ///< one an inclined support: likewise
};

struct Structure {
  std::string name;
  int dimension = 0;  ///< d: 2 or 3
  Units units;
  std::vector<std::string> node_names;
  Eigen::MatrixXd coordinates;  ///< d x nodes, length
  std::vector<Member> members;
  std::vector<Element> elements;  ///< members and elements may be mixed
  std::vector<Spring> springs;
  std::vector<Superelement> superelements;
  /// Elements of bodies whose stiffness is in a superelement: they show where its surface is.
  std::vector<Element> outlines;
  std::vector<std::array<bool, 3>> fixed;  ///< per node, per axis; the third is unused if d = 2
  std::vector<InclinedSupport> inclined;
  std::vector<Tie> ties;
  std::vector<ContactCandidate> contact;  ///< in the order of every answer
  std::vector<Load> loads;                ///< in the order of the file
  /// Intervals of the dead load among them. Nothing: every free component that carries neither dead
  /// nor reference load, with weight 1.
  std::optional<std::vector<UncertainParameter>> uncertain;
  Sources sources;
  /// What the file has that may not be meant, or was left out: a line each, with its place.
  std::vector<std::string> warnings;
};

/// How many elements and outlines there are: all that has a surface.
int body_elements(const Structure& structure);

/// One of these, elements first.
const Element& body_element(const Structure& structure, int index);

/// What an answer calls a candidate: its node, and after a bar the node that it is against; "a|b+"
/// if that one, of the largest share, has others beside it. In a corner the node is "a@left", with
/// the surface that it touches there; "a@1" by order, unless each has a surface of its own.
std::string candidate_name(const Structure& structure, std::size_t index);

/// "x", "y" or "z".
std::string_view axis_name(int axis);

/// An error about `structure`: names its file and `position`, or, without a file, the structure.
support::InputError structure_error(const Structure& structure, support::SourcePosition position,
                                    std::string_view message);

/// Entry `index` of `positions`, or no position when the structure has none.
support::SourcePosition position_of(const std::vector<support::SourcePosition>& positions,
                                    int index);

}  // namespace kusabi::problems
