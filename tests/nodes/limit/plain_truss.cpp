// Enumeration of vertices.
#include "tests/nodes/limit/plain_truss.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include <glpk.h>

namespace kusabi::limit::test {
namespace {

using problems::Load;

/// A program of GLPK: one row for each displacement, one column for each member and the last one
/// for lambda.
class Program {
 public:
  Program(const PlainTruss& truss, const Eigen::VectorXd& dead) : program_(glp_create_prob()) {
    const int rows = static_cast<int>(truss.equilibrium.rows());
    const int members = static_cast<int>(truss.equilibrium.cols());
    glp_set_obj_dir(program_.get(), GLP_MAX);
    glp_add_rows(program_.get(), rows);
    glp_add_cols(program_.get(), members + 1);
    for (int e = 0; e < rows; ++e)
      glp_set_row_bnds(program_.get(), e + 1, GLP_FX, dead(e), dead(e));
    for (int i = 0; i < members; ++i) {
      const bool lost = truss.tension(i) == 0 && truss.compression(i) == 0;
      glp_set_col_bnds(program_.get(), i + 1, lost ? GLP_FX : GLP_DB, -truss.compression(i),
                       truss.tension(i));
      set_column(i, truss.equilibrium.col(i));
    }
    glp_set_col_bnds(program_.get(), members + 1, GLP_FR, 0, 0);
    glp_set_obj_coef(program_.get(), members + 1, 1);
    set_column(members, -truss.reference);
  }

  std::optional<double> optimum() {
    glp_smcp settings;
    glp_init_smcp(&settings);
    settings.msg_lev = GLP_MSG_OFF;
    settings.presolve = GLP_ON;
    const int fault = glp_simplex(program_.get(), &settings);
    if (fault == GLP_ENOPFS || glp_get_status(program_.get()) != GLP_OPT) return {};
    return glp_get_obj_val(program_.get());
  }

 private:
  void set_column(int column, const Eigen::VectorXd& values) {
    std::vector<int> rows(1);  // GLPK counts from 1
    std::vector<double> entries(1);
    for (int e = 0; e < values.size(); ++e) {
      if (values(e) == 0) continue;
      rows.push_back(e + 1);
      entries.push_back(values(e));
    }
    glp_set_mat_col(program_.get(), column + 1, static_cast<int>(rows.size()) - 1, rows.data(),
                    entries.data());
  }

  std::unique_ptr<glp_prob, decltype([](glp_prob* each) { glp_delete_prob(each); })> program_;
};

}  // namespace

PlainTruss::PlainTruss(const problems::Structure& truss) {
  const int nodes = static_cast<int>(truss.node_names.size());
  Eigen::MatrixXi number = Eigen::MatrixXi::Constant(truss.dimension, nodes, -1);
  int count = 0;
  for (int axis = 0; axis < truss.dimension; ++axis) {
    for (int node = 0; node < nodes; ++node) {
      const auto& fixed = truss.fixed[static_cast<std::size_t>(node)];
      if (!fixed[static_cast<std::size_t>(axis)]) number(axis, node) = count++;
    }
  }
  const int members = static_cast<int>(truss.members.size());
  equilibrium.setZero(count, members);
  tension.resize(members);
  compression.resize(members);
  for (int i = 0; i < members; ++i) {
    const auto& bar = truss.members[static_cast<std::size_t>(i)];
    tension(i) = bar.yield->tension;
    compression(i) = bar.yield->compression;
    const Eigen::VectorXd along =
        (truss.coordinates.col(bar.second) - truss.coordinates.col(bar.first)).normalized();
    for (int axis = 0; axis < truss.dimension; ++axis) {
      if (number(axis, bar.first) >= 0) equilibrium(number(axis, bar.first), i) = -along(axis);
      if (number(axis, bar.second) >= 0) equilibrium(number(axis, bar.second), i) = along(axis);
    }
  }
  dead.setZero(count);
  reference.setZero(count);
  for (const auto& load : truss.loads) {
    auto& sum = load.kind == Load::Kind::dead ? dead : reference;
    for (int axis = 0; axis < truss.dimension; ++axis) {
      if (number(axis, load.node) >= 0) sum(number(axis, load.node)) += load.force(axis);
    }
  }
  uncertain.setZero(count, static_cast<Eigen::Index>(truss.uncertain->size()));
  for (Eigen::Index j = 0; j < uncertain.cols(); ++j) {
    const auto& parameter = (*truss.uncertain)[static_cast<std::size_t>(j)];
    for (const auto& each : parameter.components) {
      const int e = number(each.axis, each.node);
      if (e >= 0) uncertain(e, j) += parameter.half_width.value_or(1) * each.weight;
    }
  }
}

std::optional<double> PlainTruss::factor(const Eigen::VectorXd& zeta) const {
  return Program(*this, dead + uncertain * zeta).optimum();
}

std::optional<double> PlainTruss::min_over_corners(double alpha) const {
  const auto m = static_cast<unsigned>(uncertain.cols());
  double minimum = std::numeric_limits<double>::infinity();
  for (unsigned corner = 0; corner < 1U << m; ++corner) {
    Eigen::VectorXd zeta(m);
    for (unsigned j = 0; j < m; ++j) zeta(j) = ((corner >> j) & 1U) != 0 ? alpha : -alpha;
    const auto here = factor(zeta);
    if (!here) return {};
    minimum = std::min(minimum, *here);
  }
  return minimum;
}

}  // namespace kusabi::limit::test
