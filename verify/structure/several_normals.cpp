// Normal coordinates of one node after another; nodes opposite to other bodies come first, since
// their opposite place may depend on a node with several contact normals.
#include "verify/structure/several_normals.hpp"

#include <algorithm>
#include <utility>

#include "verify/structure/assembly.hpp"

namespace kusabi::verify {
namespace {

using Components = std::vector<Enclosure>;
/// A linear form over the free displacements.
using Form = std::map<std::size_t, Enclosure>;

void add(const Enclosure& factor, const Form& form, Form& sum) {
  if (factor.is_zero()) return;
  for (const auto& [number, weight] : form) sum[number].add_product(factor, weight);
}

Components cross(const Components& a, const Components& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The dual basis m_i with m_i.n_j = 1 if i = j and 0 otherwise; for two normals in space the third
// vector is n_1 x n_2.
std::vector<Components> dual_basis(std::vector<Components> n) {
  if (n.front().size() == 2) {
    const auto det = n[0][0] * n[1][1] - n[0][1] * n[1][0];
    return {{n[1][1] / det, -n[1][0] / det}, {-n[0][1] / det, n[0][0] / det}};
  }
  if (n.size() == 2) n.push_back(cross(n[0], n[1]));
  std::vector<Components> dual{cross(n[1], n[2]), cross(n[2], n[0]), cross(n[0], n[1])};
  Enclosure det;
  for (std::size_t k = 0; k < 3; ++k) det += n[0][k] * dual[0][k];
  for (auto& vector : dual) {
    for (auto& component : vector) component = component / det;
  }
  return dual;
}

class Corner {
 public:
  Corner(const Structure& structure, const Freedom& freedom, std::size_t node,
         std::vector<std::size_t> candidates)
      : structure_(structure), freedom_(freedom), node_(node), candidates_(std::move(candidates)) {
    for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
      if (freedom.number[node][axis] != Freedom::none) own_.push_back(freedom.number[node][axis]);
    }
    for (const auto candidate : candidates_)
      frames_.push_back(frame(structure.contact[candidate], structure.dimension));
  }

  [[nodiscard]] bool follows() const {
    return std::any_of(candidates_.begin(), candidates_.end(), [this](auto candidate) {
      return !structure_.contact[candidate].against.empty();
    });
  }

  /// Sets the spring to the mean stiffness of the node before the transformation. An axis along
  /// which nothing acts has no entry.
  void read_spring(const SparseEnclosure& stiffness) {
    Enclosure sum;
    for (const auto number : own_) {
      const auto diagonal = stiffness[number].find(number);
      if (diagonal != stiffness[number].end()) sum += diagonal->second;
    }
    spring_ = sum / Enclosure(static_cast<double>(own_.size()));
  }

  void turn(SparseEnclosure& stiffness, CandidateNumbers& numbers) const {
    const auto made = displacements();
    substitute(made, stiffness);
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      auto& seen = numbers[candidates_[i]];
      seen.push_back(own_[i]);
      for (std::size_t k = 1; k < structure_.dimension; ++k)
        seen.push_back(add_tangent(made, i, k, stiffness));
    }
  }

 private:
  /// Displacement along an axis of the place opposite to a candidate.
  [[nodiscard]] Form place(std::size_t candidate, std::size_t axis) const {
    Form form;
    for (const auto& [master, weight] : structure_.contact[candidate].against) {
      for (const auto& [number, part] : freedom_.weighted(master, axis))
        form[number].add_product(Enclosure(weight), part);
    }
    return form;
  }

  /// Displacement of the node along each axis, as forms over the new displacements.
  [[nodiscard]] std::vector<Form> displacements() const {
    const auto d = structure_.dimension;
    std::vector<Components> normals;
    for (const auto& each : frames_) normals.push_back(each.front());
    const auto dual = dual_basis(normals);
    std::vector<Form> made(d);
    for (std::size_t i = 0; i < own_.size(); ++i) {
      Form along{{own_[i], Enclosure(1)}};
      for (std::size_t axis = 0; axis < d && i < candidates_.size(); ++axis)
        add(normals[i][axis], place(candidates_[i], axis), along);
      for (std::size_t axis = 0; axis < d; ++axis) add(dual[i][axis], along, made[axis]);
    }
    return made;
  }

  /// H'K H for the rows and columns of the node.
  void substitute(const std::vector<Form>& made, SparseEnclosure& stiffness) const {
    std::map<std::size_t, const Form*> forms;  // by old number
    for (std::size_t axis = 0; axis < structure_.dimension; ++axis) {
      const auto number = freedom_.number[node_][axis];
      if (number != Freedom::none) forms[number] = &made[axis];
    }
    std::map<std::size_t, Form> rows;  // all are extracted before any is inserted
    for (const auto& [number, form] : forms) rows[number] = std::exchange(stiffness[number], {});
    for (const auto& [number, row] : rows) {
      for (const auto& [column, value] : row) stiffness[column].erase(number);
    }
    for (const auto& [number, row] : rows) {
      for (const auto& [column, value] : row) {
        const auto other = forms.find(column);
        if (other != forms.end()) {
          add_product(*forms[number], *other->second, value, stiffness);
        } else {
          const Form alone{{column, Enclosure(1)}};
          add_product(*forms[number], alone, value, stiffness);
          add_product(alone, *forms[number], value, stiffness);
        }
      }
    }
  }

  /// Adds a value times the product of two forms.
  static void add_product(const Form& a, const Form& b, const Enclosure& value,
                          SparseEnclosure& stiffness) {
    for (const auto& [row, weight] : a) {
      for (const auto& [column, other] : b) stiffness[row][column] += (weight * other) * value;
    }
  }

  std::size_t add_tangent(const std::vector<Form>& made, std::size_t i, std::size_t k,
                          SparseEnclosure& stiffness) const {
    Form stretch;
    for (std::size_t axis = 0; axis < structure_.dimension; ++axis) {
      add(-frames_[i][k][axis], made[axis], stretch);
      add(frames_[i][k][axis], place(candidates_[i], axis), stretch);
    }
    const auto number = stiffness.size();
    stiffness.emplace_back();
    stretch[number] = Enclosure(1);
    add_product(stretch, stretch, spring_, stiffness);
    return number;
  }

  const Structure& structure_;
  const Freedom& freedom_;
  std::size_t node_;
  std::vector<std::size_t> candidates_;
  // Displacement numbers of the node: at first by axis, then by normal.
  std::vector<std::size_t> own_;
  std::vector<Frame> frames_;
  Enclosure spring_;
};

}  // namespace

CandidateNumbers use_normal_coordinates(const Structure& structure, Freedom& freedom,
                                        SparseEnclosure& stiffness) {
  std::vector<Corner> all;
  for (const auto& [node, candidates] : shared_nodes(structure))
    all.emplace_back(structure, freedom, node, candidates);
  for (auto& shared : all) shared.read_spring(stiffness);
  CandidateNumbers numbers;
  for (const bool follows : {true, false}) {
    for (const auto& shared : all) {
      if (shared.follows() == follows) shared.turn(stiffness, numbers);
    }
  }
  freedom.count = stiffness.size();
  return numbers;
}

}  // namespace kusabi::verify
