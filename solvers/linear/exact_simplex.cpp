// GLPK's exact simplex method, in units in which it is exact.
#include "solvers/linear/exact_simplex.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include <glpk.h>

#include "solvers/linear/glpk_call.hpp"
#include "solvers/linear/rational_basis.hpp"

namespace kusabi::linear {
namespace {

// Limits of GLPK's exact method, which computes each step anew in rational numbers.
constexpr int steps_per_piece = 20;
constexpr int max_pieces = 50;

// The exponent of the last bit of a number that is not zero.
int last_bit(double value) {
  int exponent = 0;
  double mantissa = std::frexp(value, &exponent);
  while (mantissa != std::floor(mantissa)) {
    mantissa *= 2;
    --exponent;
  }
  return exponent;
}

// The least exponent of a set of numbers, of which all become integers by 2^-exponent.
class LastBits {
 public:
  void add(double value, int by = 0) {
    if (value != 0 && std::isfinite(value)) least_ = std::min(least_, last_bit(value) + by);
  }
  [[nodiscard]] int least() const { return least_ == none ? 0 : least_; }

 private:
  static constexpr int none = std::numeric_limits<int>::max();
  int least_ = none;
};

// A program in GLPK, in units in which all its numbers are integers: its exact method replaces other
// numbers by fractions that differ by about 1e-10 of them.
class ExactGlpk {
 public:
  explicit ExactGlpk(const LinearProgram& program)
      : rows_(static_cast<int>(program.rows.size())),
        columns_(static_cast<int>(program.columns.size())) {
    std::vector<LastBits> row_bits(program.rows.size());
    std::vector<LastBits> column_bits(program.columns.size());
    for (std::size_t j = 0; j < program.columns.size(); ++j) {
      column_bits[j].add(program.columns[j].lower);
      column_bits[j].add(program.columns[j].upper);
    }
    LastBits cost_bits;
    for (std::size_t j = 0; j < program.columns.size(); ++j)
      cost_bits.add(program.columns[j].cost, column_bits[j].least());
    for (std::size_t i = 0; i < program.rows.size(); ++i) {
      row_bits[i].add(program.rows[i].lower);
      row_bits[i].add(program.rows[i].upper);
    }
    for (const auto& [row, column, value] : program.entries)
      row_bits[static_cast<std::size_t>(row)].add(
          value, column_bits[static_cast<std::size_t>(column)].least());
    std::vector<int> at_row{0};
    std::vector<int> at_column{0};
    std::vector<double> values{0};
    for (const auto& [row, column, value] : program.entries) {
      const auto i = static_cast<std::size_t>(row);
      const auto j = static_cast<std::size_t>(column);
      at_row.push_back(row + 1);
      at_column.push_back(column + 1);
      values.push_back(whole(value, column_bits[j].least() - row_bits[i].least()));
    }
    auto* const lp = problem_.get();
    problem_.call([&] {
      // GLPK's exact method requires a row and a column.
      glp_add_rows(lp, std::max(rows_, 1));
      glp_add_cols(lp, std::max(columns_, 1));
      for (int i = 1; i <= rows_; ++i) {
        const auto at = static_cast<std::size_t>(i - 1);
        const auto& [lower, upper, name] = program.rows[at];
        const int bits = row_bits[at].least();
        glp_set_row_bnds(lp, i, glpk_bound_type(lower, upper), whole(lower, -bits),
                         whole(upper, -bits));
      }
      for (int j = 1; j <= columns_; ++j) {
        const auto at = static_cast<std::size_t>(j - 1);
        const auto& [cost, lower, upper, name] = program.columns[at];
        const int bits = column_bits[at].least();
        glp_set_col_bnds(lp, j, glpk_bound_type(lower, upper), whole(lower, -bits),
                         whole(upper, -bits));
        glp_set_obj_coef(lp, j, whole(cost, bits - cost_bits.least()));
      }
      glp_load_matrix(lp, static_cast<int>(values.size()) - 1, at_row.data(), at_column.data(),
                      values.data());
    });
  }

  /// False if a number has no double in these units.
  [[nodiscard]] bool is_exact() const { return exact_; }

  void set_basis(const Basis& basis) { problem_.set_basis(basis, rows_, columns_); }
  void use_slack_basis() {
    problem_.call([&] { glp_std_basis(problem_.get()); });
  }

  /// GLPK's code of some steps.
  int solve() {
    glp_smcp control;
    glp_init_smcp(&control);
    control.msg_lev = GLP_MSG_OFF;
    control.it_lim = steps_per_piece;
    int code = 0;
    problem_.call([&] { code = glp_exact(problem_.get(), &control); });
    return code;
  }

  [[nodiscard]] Basis basis() const { return problem_.basis(rows_, columns_); }
  /// Of an unbounded program: the variable whose edge has no end; otherwise -1.
  [[nodiscard]] int entering() const {
    const bool unbounded = glp_get_status(problem_.get()) == GLP_UNBND;
    const int added_rows = std::max(rows_, 1) - rows_;
    return unbounded ? glp_get_unbnd_ray(problem_.get()) - 1 - added_rows : -1;
  }

 private:
  double whole(double value, int exponent) {
    if (!std::isfinite(value)) return 0;
    const double scaled = std::ldexp(value, exponent);
    exact_ = exact_ && std::isfinite(scaled) && scaled == std::floor(scaled);
    return scaled;
  }

  GlpkProblem problem_;
  int rows_;
  int columns_;
  bool exact_ = true;
};

}  // namespace

ExactSolution solve_exactly(const LinearProgram& program, const Basis& start,
                            const support::Stop& stop) {
  const auto empty = [](const auto& each) { return each.lower > each.upper; };
  ExactSolution open;
  open.basis = start.empty() ? Basis(program.rows.size(), program.columns.size()) : start;
  if (std::ranges::any_of(program.rows, empty) || std::ranges::any_of(program.columns, empty)) {
    open.status = LinearStatus::infeasible;
    return open;
  }
  bool too_much = false;
  if (!start.empty()) {
    if (auto found = proof_by_basis(program, start, -1, stop, too_much)) return *std::move(found);
    if (too_much) return open;  // the exact method would begin with the same elimination
  }
  ExactGlpk glpk(program);
  if (!glpk.is_exact()) return open;
  // From the start, and, if the basis found there proves nothing or there is none, from slacks.
  for (const bool from_slacks : {false, true}) {
    if (from_slacks || start.empty()) {
      glpk.use_slack_basis();
    } else {
      glpk.set_basis(start);
    }
    int code = GLP_EITLIM;
    for (int piece = 0; piece < max_pieces && code == GLP_EITLIM; ++piece) {
      if (support::is_requested(stop)) break;
      code = glpk.solve();
    }
    if (support::is_requested(stop)) {
      open.status = LinearStatus::interrupted;
      return open;
    }
    if (code != 0) continue;
    auto found = proof_by_basis(program, glpk.basis(), glpk.entering(), stop, too_much);
    if (found) return *std::move(found);
  }
  return open;
}

}  // namespace kusabi::linear
