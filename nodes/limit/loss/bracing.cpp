// Orthogonalisation of the columns of B, one after another.
#include "nodes/limit/loss/bracing.hpp"

#include <vector>

namespace kusabi::limit {
namespace {

using support::IndexSet;

/// A column with a smaller share outside of the span of the others does not brace anything.
constexpr double independent = 1e-6;

IndexSet rows_of(const problems::LimitModel& model, int member) {
  IndexSet rows;
  for (Eigen::SparseMatrix<double>::InnerIterator entry(model.equilibrium, member); entry; ++entry)
    rows.insert(static_cast<int>(entry.row()));
  return rows;
}

/// The span of some columns.
class Span {
 public:
  explicit Span(int rows) : rows_(rows) {}

  // @return whether the column is independent of the others, and so added
  bool add(Eigen::VectorXd column) {
    const double size = column.norm();
    if (size == 0 || static_cast<int>(basis_.size()) == rows_) return false;
    for (int time = 0; time < 2; ++time) {
      for (const auto& each : basis_) column -= each.dot(column) * each;
    }
    const double rest = column.norm();
    if (rest < independent * size) return false;
    basis_.emplace_back(column / rest);
    return true;
  }
  [[nodiscard]] int rank() const { return static_cast<int>(basis_.size()); }

 private:
  int rows_;
  std::vector<Eigen::VectorXd> basis_;
};

}  // namespace

IndexSet braced(const problems::LimitModel& model, const IndexSet& stressed,
                const IndexSet& available, const IndexSet& preferred) {
  Span span(model.free_count());
  IndexSet touched;
  const auto column = [&](int member) { return Eigen::VectorXd(model.equilibrium.col(member)); };
  for (const int member : stressed) {
    span.add(column(member));
    touched |= rows_of(model, member);
  }
  Eigen::VectorXd reference = Eigen::VectorXd::Zero(model.free_count());
  for (const int row : touched) reference(row) = model.reference(row);
  span.add(reference);
  auto braces = stressed;
  // Adds what braces. @param within only members that touch nothing else
  const auto add = [&](const IndexSet& choice, bool within) {
    const auto before = braces;
    for (const int member : choice - before) {
      if (span.rank() >= touched.size()) break;
      const auto rows = rows_of(model, member);
      if (rows.empty() || (within ? !touched.includes(rows) : !touched.meets(rows))) continue;
      if (!span.add(column(member))) continue;
      braces.insert(member);
      touched |= rows;
    }
    return braces != before;
  };
  const IndexSet choices[] = {available & preferred, available - preferred};
  for (const auto& choice : choices) add(choice, true);
  // Members added touch further displacements, which other members may brace.
  for (bool any = true; any;) {
    any = false;
    for (const auto& choice : choices) any = add(choice, false) || any;
  }
  return braces;
}

}  // namespace kusabi::limit
