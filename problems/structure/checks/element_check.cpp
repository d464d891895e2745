// Checks of material, nodes and shape of each element.
#include "problems/structure/checks/element_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/checks/structure_check.hpp"
#include "problems/structure/model/element_shape.hpp"

namespace kusabi::problems {
namespace {

class ElementCheck {
 public:
  ElementCheck(const Structure& structure, int index)
      : structure_(structure),
        index_(index),
        element_(structure.elements[static_cast<std::size_t>(index)]),
        traits_(shape_traits(element_.shape)) {}

  void material() const;
  void nodes() const;
  void shape() const;

 private:
  std::string name(int node) const { return quoted_name(structure_, node); }
  std::string corner_names() const;
  [[noreturn]] void fail(std::string_view message) const {
    throw structure_error(structure_, position_of(structure_.sources.elements, index_), message);
  }
  [[noreturn]] void fail_material(std::string_view message) const {
    throw structure_error(structure_, position_of(structure_.sources.materials, index_), message);
  }

  const Structure& structure_;
  int index_;
  const Element& element_;
  const ShapeTraits& traits_;
};

void ElementCheck::material() const {
  const auto in_range = [](double value) {
    return value >= smallest_magnitude && value <= largest_magnitude;
  };
  // The condition is false for NaN.
  if (!in_range(element_.modulus)) {
    fail_material(fmt::format("E is {:g}; expected a positive modulus between {:g} and {:g}",
                              element_.modulus, smallest_magnitude, largest_magnitude));
  }
  const bool in_plane = structure_.dimension == 2;
  if (in_plane && !in_range(element_.thickness)) {
    fail_material(fmt::format("thickness is {:g}; expected a length between {:g} and {:g}",
                              element_.thickness, smallest_magnitude, largest_magnitude));
  }
  const bool incompressible =
      in_plane && element_.state == PlaneState::stress && element_.ratio == 0.5;
  if (!((element_.ratio > -1 && element_.ratio < 0.5) || incompressible)) {
    fail_material(
        fmt::format("nu is {:g}; expected a number above -1 and below 0.5 (in plane "
                    "stress up to 0.5)",
                    element_.ratio));
  }
}

void ElementCheck::nodes() const {
  if (traits_.dimension != structure_.dimension) {
    fail(fmt::format("a {} in dimension {}; expected an element {}", traits_.name,
                     structure_.dimension,
                     structure_.dimension == 2 ? "in the plane" : "in space"));
  }
  if (element_.nodes.size() != traits_.nodes.size()) {
    fail(fmt::format("a {} with {} nodes; expected {}", traits_.name, element_.nodes.size(),
                     traits_.nodes.size()));
  }
  const auto count = static_cast<int>(structure_.node_names.size());
  for (const int node : element_.nodes) {
    if (node < 0 || node >= count) {
      fail(fmt::format("element {} names a node that does not exist", index_));
    }
    if (std::ranges::count(element_.nodes, node) > 1) {
      fail(fmt::format("element with node {} twice; expected different nodes", name(node)));
    }
  }
}

std::string ElementCheck::corner_names() const {
  std::string names;
  for (std::size_t vertex = 0; vertex < static_cast<std::size_t>(traits_.vertices); ++vertex) {
    if (vertex > 0) names += ", ";
    names += name(element_.nodes[vertex]);
  }
  return names;
}

void ElementCheck::shape() const {
  double size = 0;
  for (const int node : element_.nodes)
    size = std::max(size, structure_.coordinates.col(node).cwiseAbs().maxCoeff());
  const Eigen::ArrayXd values = jacobian_determinants(structure_, element_).array();
  const double minimum =
      zero_length * size * std::pow(element_extent(structure_, element_), structure_.dimension - 1);
  if ((values > minimum).all() || (values < -minimum).all()) return;
  if (element_.shape == ElementShape::quadrilateral4) {
    fail(
        fmt::format("the element at {} is not a convex quadrilateral; expected corners in order "
                    "around it",
                    corner_names()));
  }
  // The sign of the majority determines the wrong ones.
  const bool negative = (values < 0).count() > values.size() / 2;
  const Eigen::ArrayXd right = negative ? Eigen::ArrayXd(-values) : values;
  Eigen::Index where = 0;
  while (right(where) > minimum) ++where;
  const std::string place =
      where < traits_.vertices
          ? fmt::format("at node {}", name(element_.nodes[static_cast<std::size_t>(where)]))
          : std::string("inside");
  fail(
      fmt::format("the {} at {} is flat or inverted {}: its Jacobian determinant does not have "
                  "one sign; expected nodes in the order of docs/problem-files.md, {}",
                  traits_.name, corner_names(), place,
                  traits_.quadratic ? "and middles of edges near the middle" : "and a volume"));
}

}  // namespace

void check_elements(const Structure& structure) {
  for (int index = 0; index < static_cast<int>(structure.elements.size()); ++index) {
    const ElementCheck check(structure, index);
    check.material();
    check.nodes();
    check.shape();
  }
}

}  // namespace kusabi::problems
