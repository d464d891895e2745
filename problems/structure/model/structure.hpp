// Structure as its file describes it: bars and elements in the user's units, supports, the nodes
// that may touch an obstacle (Gamma_D, Gamma_N and Gamma_C of the wedged paper's section 2), and
// loads (sections 2.2 and 3.1 of the limit paper).
//
// Plain data, filled from a file or by a program; a `CheckedStructure` obeys `check_structure`.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "support/input_error.hpp"

namespace kusabi::problems {

/// The user's units, which all answers have; they are not converted.
struct Units {
  std::string length;
  std::string force;
};

/// Yield forces of a perfectly plastic bar in tension and compression, both >= 0.
struct YieldForces {
  double tension = 0;
  double compression = 0;
  /// Of a strut: the strength in compression that remains after buckling; nothing: no strut.
  std::optional<double> residual{};

  friend bool operator==(const YieldForces&, const YieldForces&) = default;
};

/// A bar between two nodes.
struct Member {
  int first;
  int second;
  double axial_stiffness = 0;          ///< E A, force; 0: not given; not required by limit analysis
  std::optional<YieldForces> yield{};  ///< q^y; nothing: not given
  double mass = 0;                     ///< of a unit of length
  double expansion = 0;                ///< strain by a unit of temperature
};

/// A force at a node: part of f_D, or of f_R that the load factor multiplies (limit paper (3)).
struct Load {
  enum class Kind { dead, reference };
  Kind kind;
  int node;
  Eigen::VectorXd force;    ///< d
  std::string load_case{};  ///< empty: it is of all cases
};

/// One component of an uncertain parameter of the dead load.
struct UncertainComponent {
  int node;
  int axis;
  double weight = 1;  ///< not zero: the half-width for alpha = 1
};

/// A parameter zeta_j of the dead load with an unknown value within its half-width, and its column
/// of T (limit paper (6), (7)).
struct UncertainParameter {
  /// Empty: a single component, which serves as its name, with a positive weight.
  std::string name;
  std::vector<UncertainComponent> components;
  std::optional<double> half_width{};  ///< of zeta_j, force; nothing: the value of alpha
  std::string group{};                 ///< name of its group in the file; may be empty
  std::string load_case{};             ///< empty: in all cases
};

/// The factors of an action in one load case, a combination by EN 1990. Its part of the dead load is
/// the forces of the file times each factor between both.
struct ActionFactors {
  std::string action;
  double lower;
  double upper;
  bool reference = false;  ///< the load factor multiplies `upper` times the action
  std::string load_case{};
};

/// Condition of a plane element in the third direction.
enum class PlaneState {
  stress,  ///< thin: no stress
  strain,  ///< long: no strain
};

/// Shape of an element: the number and order of its nodes (docs/problem-files.md).
enum class ElementShape {
  triangle3,
  triangle6,
  quadrilateral4,
  quadrilateral8,
  tetrahedron4,
  tetrahedron10,
  hexahedron8,
  hexahedron20,
  prism6,
  prism15,
  pyramid5,
};

/// An element of an isotropic body, in the plane or in space.
struct Element {
  std::vector<int> nodes;  ///< vertices first, in circular order; in the order of its shape
  double modulus;          ///< E, force/length^2
  double ratio;            ///< nu, Poisson's ratio
  double thickness;        ///< length; unused in space, as is the plane state
  PlaneState state;
  ElementShape shape = ElementShape::quadrilateral4;
  double density = 0;    ///< mass of a unit of volume
  double expansion = 0;  ///< strain by a unit of temperature, in all directions
};

/// A spring between a node and the ground along one axis.
struct Spring {
  int node;
  int axis;
  double stiffness;  ///< > 0, force/length
};

/// Meaning of a row of a superelement: the displacement of a node along an axis, or an internal
/// unknown, such as a rotation, without supports or contacts.
struct SuperelementRow {
  int node = -1;  ///< -1: an internal unknown
  int axis = 0;
};

/// One or several bodies whose stiffness was computed by another program.
struct Superelement {
  std::vector<SuperelementRow> rows;      ///< each displacement of a node at most once
  Eigen::SparseMatrix<double> stiffness;  ///< both triangles, force/length; taken as exact
  /// Relative rounding error of each number due to the digits of its file. Answers do not include
  /// it, but a body constrained only by less than this counts as unconstrained.
  double rounding = 0;
};

/// The weight of a node in the place opposite to a contact candidate, or in a multi-point
/// constraint.
struct WeightedNode {
  int node;
  double weight;
};

/// A multi-point constraint: the displacement of a dependent node is the sum of weight times those
/// of its masters.
struct MultiPointConstraint {
  int node;
  std::vector<WeightedNode> to;
};

/// A support in a direction that is not an axis: u . direction = 0 for the displacement u of its
/// node.
struct InclinedSupport {
  int node;
  Eigen::VectorXd direction;  ///< d, any positive length
};

/// A node on the surface of the rigid obstacle or of another body, without gap.
struct ContactCandidate {
  int node;
  Eigen::VectorXd normal;  ///< d, unit, outward normal of the obstacle: u_n >= 0 is separation
  std::optional<Eigen::VectorXd> tangent;  ///< d, given first tangent, any length
  double friction = 1;                     ///< mu_i, relative to the coefficient of a search
  /// d, the normal before normalisation; nothing: `normal` is exact
  std::optional<Eigen::VectorXd> direction{};
  /// The opposite place on another body: its displacement is the sum of weight times those of the
  /// nodes. Empty: a rigid obstacle. The displacement of the candidate is that of `node` minus
  /// this, and the reaction acts on both with opposite signs.
  std::vector<WeightedNode> against{};
  /// Name of the opposite surface in the file; distinguishes candidates at one node.
  std::string surface{};
  /// Distance from the obstacle before any force acts, length; negative: interference. Only states
  /// under load depend on it (docs/theory/loads.md).
  double clearance = 0;
};

/// Position of each entry in the file, for error messages. Structures made by programs leave the
/// vectors empty.
struct Sources {
  std::string file;
  std::vector<std::string> more_files;           ///< `SourcePosition::file` counts them from 1
  std::vector<support::SourcePosition> nodes;    ///< of each node: its name
  std::vector<support::SourcePosition> members;  ///< of each member: its pair of nodes
  std::vector<support::SourcePosition> axial_stiffnesses;  ///< of each member: the EA of its group
  std::vector<support::SourcePosition> elements;   ///< of each element: its nodes, or its mesh
  std::vector<support::SourcePosition> materials;  ///< of each element: the head of its group
  std::vector<support::SourcePosition> yields;     ///< of each member: the yield of its group
  std::vector<support::SourcePosition> contact;    ///< of each candidate: its name in the list
  std::vector<support::SourcePosition> normals;    ///< of each candidate: the normal of its group
  std::vector<support::SourcePosition> tangents;   ///< of each candidate: the tangent of its group
  std::vector<support::SourcePosition> frictions;  ///< of each candidate: the friction of its group
  std::vector<support::SourcePosition> loads;      ///< of each load: its node in the list
  /// Of each component, by parameters: its node in the list.
  std::vector<support::SourcePosition> uncertain;
  std::vector<support::SourcePosition> superelements;  ///< of each superelement: its file
  std::vector<support::SourcePosition> springs;        ///< of each spring: its node in the list
  /// Of each multi-point constraint: its node in the list.
  std::vector<support::SourcePosition> ties;
  /// Of each inclined support: its node in the list.
  std::vector<support::SourcePosition> inclined;
};

struct Structure {
  std::string name;
  int dimension = 0;  ///< d: 2 or 3
  Units units;
  std::vector<std::string> node_names;
  std::map<std::string, int> more_names{};  ///< further names of nodes, such as those of two meshes
  Eigen::MatrixXd coordinates;              ///< d x nodes, length
  std::vector<Member> members;
  std::vector<Element> elements;  ///< members and elements may be mixed
  std::vector<Spring> springs;
  std::vector<Superelement> superelements;
  /// Elements of bodies whose stiffness is a superelement, which define their surface.
  std::vector<Element> outlines;
  std::vector<std::array<bool, 3>> fixed;  ///< by node and axis; the third is unused if d = 2
  std::vector<InclinedSupport> inclined;
  std::vector<MultiPointConstraint> ties;
  std::vector<ContactCandidate> contact;  ///< in the order of all answers
  std::vector<Load> loads;                ///< in the order of the file, then the weight
  /// Forces on the nodes that have the effect of the strains imposed by temperature and by
  /// displaced supports, d x nodes; empty: none. Only states under load depend on them.
  Eigen::MatrixXd imposed_forces;
  /// Uncertain components of the dead load. Nothing: every free component without dead and
  /// reference load, with weight 1.
  std::optional<std::vector<UncertainParameter>> uncertain;
  /// The actions of each load case that is a combination by EN 1990; empty: other load cases.
  std::vector<ActionFactors> actions{};
  Sources sources;
  /// Questionable or ignored entries of the file, a line each, with their places.
  std::vector<std::string> warnings;
};

/// The number of elements and outlines.
int body_elements(const Structure& structure);

/// An element or outline, elements first.
const Element& body_element(const Structure& structure, int index);

/// True if some members are struts.
bool has_struts(const Structure& structure);

/// The structure with all struts at their residual strength.
Structure after_buckling(Structure structure);

/// The node with this name, which may be its first or a further one; nothing if there is none.
std::optional<int> node_named(const Structure& structure, const std::string& name);

/// The name of a node in quotes, for messages.
std::string quoted_name(const Structure& structure, int node);

/// Name of a candidate in answers: its node and, after a bar, the opposite node; "a|b+" if b, the
/// node of the largest weight, is one of several. At a node with several normals "a@left" by the
/// opposite surface, or "a@1" by order unless each has a surface of its own.
std::string candidate_name(const Structure& structure, std::size_t index);

/// The name "x", "y" or "z".
std::string_view axis_name(int axis);

/// An error on `structure` with its file and `position`, or without a file, "the structure".
support::InputError structure_error(const Structure& structure, support::SourcePosition position,
                                    std::string_view message);

/// Entry `index` of `positions`, or no position if the structure has none.
support::SourcePosition position_of(const std::vector<support::SourcePosition>& positions,
                                    int index);

}  // namespace kusabi::problems
