// Assembly of the cone program of a node, row by row.
#include "solvers/conic/cone_program.hpp"

#include <stdexcept>

namespace kusabi::conic {

using support::IndexSet;

namespace {

using Kind = ConePart::Kind;

bool has(const IndexSet& set, Eigen::Index candidate) {
  return set.contains(static_cast<int>(candidate));
}

// Appends a part; parts of one kind are merged, except second-order cones.
void add(std::vector<ConePart>& parts, Kind kind, Eigen::Index size) {
  const bool grows = !parts.empty() && parts.back().kind == kind && kind != Kind::second_order;
  if (grows) {
    parts.back().size += static_cast<int>(size);
  } else {
    parts.push_back({kind, static_cast<int>(size)});
  }
}

class NodeRows {
 public:
  NodeRows(const Eigen::MatrixXd& compliance, std::span<const double> friction)
      : compliance_(compliance),
        friction_(friction),
        m_(static_cast<Eigen::Index>(friction.size())),
        d_(compliance.rows() / m_) {
    const Eigen::Index size = compliance.rows();
    program_.costs = Eigen::VectorXd::Unit(size + 1, size);
    program_.matrix.setZero(1 + m_ + size, size + 1);  // upper bound of the size
    program_.constants.setZero(1 + m_ + size);
  }

  ConeProgram make(const IndexSet& contact, const IndexSet& separated) {
    add_reactions(separated);
    add_sum();
    for (Eigen::Index i = 0; i < m_; ++i) {
      if (has(contact, i)) next(Kind::zero, 1).head(size()) = compliance_.row(d_ * i);
    }
    for (Eigen::Index i = 0; i < m_; ++i) {
      if (has(contact, i)) continue;
      auto row = next(Kind::nonnegative, 1);
      row.head(size()) = compliance_.row(d_ * i);
      row(size()) = -1;
    }
    for (Eigen::Index i = 0; i < m_; ++i) {
      if (!has(separated, i)) add_friction_cone(i);
    }
    program_.matrix.conservativeResize(used_, Eigen::NoChange);
    program_.constants.conservativeResize(used_);
    return program_;
  }

 private:
  [[nodiscard]] Eigen::Index size() const { return compliance_.rows(); }
  [[nodiscard]] double friction(Eigen::Index candidate) const {
    return friction_[static_cast<std::size_t>(candidate)];
  }

  // Allocates `count` rows. @return the first
  Eigen::MatrixXd::RowXpr next(Kind kind, Eigen::Index count) {
    add(program_.rows, kind, count);
    used_ += count;
    return program_.matrix.row(used_ - count);
  }

  void add_reactions(const IndexSet& separated) {
    for (Eigen::Index i = 0; i < m_; ++i) {
      const bool slides = friction(i) > 0;
      const bool none = has(separated, i);
      add(program_.columns, none ? Kind::zero : Kind::free, 1);
      add(program_.columns, none || !slides ? Kind::zero : Kind::free, d_ - 1);
    }
    add(program_.columns, Kind::free, 1);
  }

  void add_sum() {
    auto row = next(Kind::zero, 1);
    for (Eigen::Index i = 0; i < m_; ++i) row(d_ * i) = 1;
    program_.constants(used_ - 1) = -1;
  }

  void add_friction_cone(Eigen::Index i) {
    const double mu = friction(i);
    auto row = next(mu > 0 ? Kind::second_order : Kind::nonnegative, mu > 0 ? d_ : 1);
    row(d_ * i) = mu > 0 ? mu : 1;
    row(size()) = -1;
    if (mu == 0) return;
    for (Eigen::Index axis = 1; axis < d_; ++axis) {
      program_.matrix(used_ - d_ + axis, d_ * i + axis) = 1;
    }
  }

  const Eigen::MatrixXd& compliance_;
  std::span<const double> friction_;
  Eigen::Index m_, d_;
  ConeProgram program_;
  Eigen::Index used_ = 0;
};

}  // namespace

ConeProgram node_cone_program(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                              const IndexSet& contact, const IndexSet& separated) {
  const std::size_t m = friction.size();
  const auto size = static_cast<std::size_t>(compliance.rows());
  if (m < 1 || compliance.cols() != compliance.rows() || (size != 2 * m && size != 3 * m)) {
    throw std::invalid_argument("the compliance does not fit the candidates");
  }
  const auto all = IndexSet::below(static_cast<int>(m));
  if (contact.meets(separated) || !all.includes(contact | separated)) {
    throw std::invalid_argument("the sets overlap, or name a candidate that does not exist");
  }
  return NodeRows(compliance, friction).make(contact, separated);
}

}  // namespace kusabi::conic
