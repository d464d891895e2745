// Simplex: owner of a glp_prob.
#include "solvers/linear/simplex.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glpk.h>

#include "solvers/linear/glpk_call.hpp"

namespace kusabi::linear {
namespace {

// Tolerance relative to the scaled program. GLPK's default of 1e-7 suits general programs; scaled
// ones with a few hundred rows can be solved more accurately.
constexpr double primal_tolerance = 1e-9;
constexpr double dual_tolerance = 1e-9;

// Limit of steps per row, since GLPK's methods can cycle. Ordinary programs take some steps per
// row.
constexpr int steps_per_row = 50;
constexpr int min_steps = 2000;

// Size of a piece of a solve that may be stopped: a number of steps that take about a second at
// most. A step costs as much as reading the program once or twice; at the beginning of a piece GLPK
// copies the program, entry by entry, and discards its steepest-edge weights.
constexpr double read_entries_per_piece = 2e8;
constexpr double min_piece = 500;

double finite_or_zero(double bound) {
  return std::isfinite(bound) ? bound : 0;
}

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(fmt::format("linear program: {}", what));
}

void require_bounds(double lower, double upper) {
  require(!std::isnan(lower) && !std::isnan(upper), "a bound is not a number");
  require(lower < infinity && upper > -infinity, "the bounds are contradictory");
}

}  // namespace

struct Simplex::Problem : GlpkProblem {
  // GLPK counts from 1.
  [[nodiscard]] int row(int index) const {
    if (index < 0 || index >= glp_get_num_rows(get())) throw std::out_of_range("no such row");
    return index + 1;
  }
  [[nodiscard]] int column(int index) const {
    if (index < 0 || index >= glp_get_num_cols(get())) throw std::out_of_range("no such column");
    return index + 1;
  }

  // Replaces b by the solution that `routine` computes.
  void solve(void (*routine)(glp_prob* lp, double* b), std::vector<double>& b) const {
    b.insert(b.begin(), 0);
    call([&] { routine(get(), b.data()); });
    b.erase(b.begin());
  }
};

Simplex::Simplex(const LinearProgram& program) : problem_(std::make_unique<Problem>()) {
  const auto row_count = static_cast<int>(program.rows.size());
  const auto column_count = static_cast<int>(program.columns.size());
  row_empty_.resize(program.rows.size());
  column_empty_.resize(program.columns.size());
  auto* const lp = problem_->get();
  problem_->call([&] {
    if (row_count > 0) glp_add_rows(lp, row_count);
    if (column_count > 0) glp_add_cols(lp, column_count);
  });
  for (int i = 0; i < row_count; ++i) {
    const auto& row = program.rows[static_cast<std::size_t>(i)];
    set_row_bounds(i, row.lower, row.upper);
  }
  for (int j = 0; j < column_count; ++j) {
    const auto& column = program.columns[static_cast<std::size_t>(j)];
    set_column_bounds(j, column.lower, column.upper);
    set_cost(j, column.cost);
  }
  set_constant(program.constant);
  std::vector<int> at_row{0};
  std::vector<int> at_column{0};
  std::vector<double> values{0};
  for (const auto& [row, column, value] : program.entries) {
    require(row >= 0 && row < row_count && column >= 0 && column < column_count,
            "an entry is outside of the matrix");
    require(std::isfinite(value), "an entry is not finite");
    at_row.push_back(row + 1);
    at_column.push_back(column + 1);
    values.push_back(value);
  }
  // GLPK's scale factors are roots of products: those of numbers out of this range underflow to
  // zero.
  const bool has_scale = std::all_of(values.begin() + 1, values.end(), [](double value) {
    constexpr double largest = 1e100;
    return value == 0 || (std::abs(value) < largest && std::abs(value) > 1 / largest);
  });
  const auto count = static_cast<int>(program.entries.size());
  require(glp_check_dup(row_count, column_count, count, at_row.data(), at_column.data()) == 0,
          "an entry occurs twice");
  problem_->call([&] {
    glp_load_matrix(lp, count, at_row.data(), at_column.data(), values.data());
    if (has_scale) glp_scale_prob(lp, GLP_SF_AUTO);
    glp_std_basis(lp);
  });
}

Simplex::Simplex(Simplex&& other) noexcept = default;
Simplex& Simplex::operator=(Simplex&& other) noexcept = default;
Simplex::~Simplex() = default;

int Simplex::rows() const {
  return glp_get_num_rows(problem_->get());
}

int Simplex::columns() const {
  return glp_get_num_cols(problem_->get());
}

void Simplex::set_column_bounds(int column, double lower, double upper) {
  require_bounds(lower, upper);
  column_empty_.at(static_cast<std::size_t>(column)) = lower > upper;
  if (lower > upper) return;
  problem_->call([&] {
    glp_set_col_bnds(problem_->get(), column + 1, glpk_bound_type(lower, upper),
                     finite_or_zero(lower), finite_or_zero(upper));
  });
}

void Simplex::set_row_bounds(int row, double lower, double upper) {
  require_bounds(lower, upper);
  row_empty_.at(static_cast<std::size_t>(row)) = lower > upper;
  if (lower > upper) return;
  problem_->call([&] {
    glp_set_row_bnds(problem_->get(), row + 1, glpk_bound_type(lower, upper), finite_or_zero(lower),
                     finite_or_zero(upper));
  });
}

void Simplex::set_cost(int column, double cost) {
  require(std::isfinite(cost), "a cost is not finite");
  const int number = problem_->column(column);
  problem_->call([&] { glp_set_obj_coef(problem_->get(), number, cost); });
}

void Simplex::set_constant(double constant) {
  require(std::isfinite(constant), "the constant is not finite");
  problem_->call([&] { glp_set_obj_coef(problem_->get(), 0, constant); });
}

int Simplex::add_row(double lower, double upper, std::span<const LinearTerm> terms) {
  std::vector<int> at{0};
  std::vector<double> values{0};
  for (const auto& [column, value] : terms) {
    require(std::isfinite(value), "an entry is not finite");
    if (value == 0) continue;
    at.push_back(column + 1);
    values.push_back(value);
  }
  const int index = rows();
  problem_->call([&] {
    glp_add_rows(problem_->get(), 1);
    glp_set_mat_row(problem_->get(), index + 1, static_cast<int>(at.size()) - 1, at.data(),
                    values.data());
  });
  row_empty_.push_back(false);
  set_row_bounds(index, lower, upper);
  return index;
}

int Simplex::add_column(const LinearColumn& column, std::span<const LinearEntry> entries) {
  std::vector<int> at{0};
  std::vector<double> values{0};
  for (const auto& entry : entries) {
    require(std::isfinite(entry.value), "an entry is not finite");
    if (entry.value == 0) continue;
    at.push_back(entry.row + 1);
    values.push_back(entry.value);
  }
  const int index = columns();
  problem_->call([&] {
    glp_add_cols(problem_->get(), 1);
    glp_set_mat_col(problem_->get(), index + 1, static_cast<int>(at.size()) - 1, at.data(),
                    values.data());
  });
  column_empty_.push_back(false);
  set_column_bounds(index, column.lower, column.upper);
  set_cost(index, column.cost);
  return index;
}

void Simplex::drop_rows_from(int first) {
  std::vector<int> dropped(static_cast<std::size_t>(std::max(0, rows() - first)));
  std::iota(dropped.begin(), dropped.end(), first);
  drop_rows(dropped);
}

void Simplex::drop_rows(std::span<const int> dropped) {
  if (dropped.empty()) return;
  std::vector<int> numbers{0};
  for (const int row : dropped) numbers.push_back(problem_->row(row));
  problem_->call(
      [&] { glp_del_rows(problem_->get(), static_cast<int>(dropped.size()), numbers.data()); });
  for (auto row = dropped.rbegin(); row != dropped.rend(); ++row) {
    row_empty_.erase(row_empty_.begin() + *row);
  }
  int basic = 0;
  for (int i = 1; i <= rows(); ++i) basic += glp_get_row_stat(problem_->get(), i) == GLP_BS ? 1 : 0;
  for (int j = 1; j <= columns(); ++j)
    basic += glp_get_col_stat(problem_->get(), j) == GLP_BS ? 1 : 0;
  if (basic != rows()) use_slack_basis();
}

void Simplex::scale() {
  problem_->call([&] { glp_scale_prob(problem_->get(), GLP_SF_AUTO); });
}

void Simplex::unscale() {
  problem_->call([&] { glp_unscale_prob(problem_->get()); });
  refactorise();
}

// ---- solving -----------------------------------------------------------------------------------

bool Simplex::empty_bounds() const {
  const auto holds = [](bool empty) { return empty; };
  return std::any_of(row_empty_.begin(), row_empty_.end(), holds) ||
         std::any_of(column_empty_.begin(), column_empty_.end(), holds);
}

LinearStatus Simplex::solve_dual(const SolveLimits& limits) {
  return status_ = solve(GLP_DUALP, limits);
}

LinearStatus Simplex::solve_primal(const SolveLimits& limits) {
  return status_ = solve(GLP_PRIMAL, limits);
}

LinearStatus Simplex::solve_robustly(const SolveLimits& limits) {
  status_ = solve(GLP_DUALP, limits);
  if (status_ == LinearStatus::failed) status_ = solve(GLP_PRIMAL, limits);
  for (const int method : {GLP_PRIMAL, GLP_DUALP}) {
    if (status_ != LinearStatus::failed) break;
    problem_->call([&] { glp_adv_basis(problem_->get(), 0); });
    status_ = solve(method, limits);
  }
  return status_;
}

int Simplex::steps_per_piece() const {
  const double size = static_cast<double>(rows()) + static_cast<double>(columns()) +
                      static_cast<double>(glp_get_num_nz(problem_->get()));
  return static_cast<int>(std::max(min_piece, read_entries_per_piece / std::max(1.0, size)));
}

LinearStatus Simplex::solve(int method, const SolveLimits& limits) {
  ++solves_;
  if (empty_bounds()) return LinearStatus::infeasible;
  glp_smcp control;
  glp_init_smcp(&control);
  control.msg_lev = GLP_MSG_OFF;
  control.meth = method;
  control.tol_bnd = primal_tolerance;
  control.tol_dj = dual_tolerance;
  const int enough = min_steps + steps_per_row * (rows() + columns());
  const int maximum = std::min(limits.iterations, enough);
  if (std::isfinite(limits.cutoff)) control.obj_ul = limits.cutoff;
  const int before = glp_get_it_cnt(problem_->get());
  const int piece = limits.stop ? steps_per_piece() : maximum;
  int done = 0;
  int code = 0;
  for (;;) {
    control.it_lim = std::min(piece, maximum - done);
    problem_->call([&] { code = glp_simplex(problem_->get(), &control); });
    done = std::max(0, glp_get_it_cnt(problem_->get()) - before);
    if (code != GLP_EITLIM || done >= maximum) break;
    if (support::is_requested(limits.stop)) {
      iterations_ += static_cast<std::uint64_t>(done);
      return LinearStatus::interrupted;
    }
  }
  iterations_ += static_cast<std::uint64_t>(done);
  if (code == GLP_EOBJUL) return LinearStatus::cut_off;
  if (code == GLP_EITLIM) {
    return limits.iterations <= enough ? LinearStatus::stopped : LinearStatus::failed;
  }
  if (code != 0) return LinearStatus::failed;
  switch (glp_get_status(problem_->get())) {
    case GLP_OPT:
      return LinearStatus::optimal;
    case GLP_NOFEAS:
      return LinearStatus::infeasible;
    case GLP_UNBND:
      return LinearStatus::unbounded;
    default:
      return LinearStatus::failed;
  }
}

Basis Simplex::basis() const {
  return problem_->basis(rows(), columns());
}

void Simplex::set_basis(const Basis& basis) {
  require(basis.rows() <= static_cast<std::size_t>(rows()) &&
              basis.columns() == static_cast<std::size_t>(columns()),
          "the basis is of another program");
  problem_->set_basis(basis, rows(), columns());
  refactorise();
}

void Simplex::use_slack_basis() {
  problem_->call([&] { glp_std_basis(problem_->get()); });
  refactorise();
}

// GLPK keeps a basis reached by steps as a product form, whose rounding differs from that of a
// fresh factorisation. GLPK discards it when a basic variable is made nonbasic.
void Simplex::refactorise() {
  problem_->call([&] {
    for (int i = 1; i <= rows(); ++i) {
      if (glp_get_row_stat(problem_->get(), i) != GLP_BS) continue;
      glp_set_row_stat(problem_->get(), i, GLP_NL);
      glp_set_row_stat(problem_->get(), i, GLP_BS);
      return;
    }
    for (int j = 1; j <= columns(); ++j) {
      if (glp_get_col_stat(problem_->get(), j) != GLP_BS) continue;
      glp_set_col_stat(problem_->get(), j, GLP_NL);
      glp_set_col_stat(problem_->get(), j, GLP_BS);
      return;
    }
  });
}

// ---- the last solve ----------------------------------------------------------------------------

double Simplex::objective() const {
  return glp_get_obj_val(problem_->get());
}

double Simplex::value(int column) const {
  return glp_get_col_prim(problem_->get(), problem_->column(column));
}

double Simplex::dual(int row) const {
  return glp_get_row_dual(problem_->get(), problem_->row(row));
}

double Simplex::reduced_cost(int column) const {
  return glp_get_col_dual(problem_->get(), problem_->column(column));
}

std::vector<double> Simplex::values() const {
  std::vector<double> all(static_cast<std::size_t>(columns()));
  for (int j = 0; j < columns(); ++j) all[static_cast<std::size_t>(j)] = value(j);
  return all;
}

std::vector<double> Simplex::duals() const {
  std::vector<double> all(static_cast<std::size_t>(rows()));
  for (int i = 0; i < rows(); ++i) all[static_cast<std::size_t>(i)] = dual(i);
  return all;
}

// The basic variable that violates its bound and that no step can improve. Its row of the tableau,
// e'B^-1 (I | -A) x = 0, proves infeasibility.
std::vector<double> Simplex::farkas() {
  const auto [place, sign] = contradicting();
  if (place < 0) return {};
  std::vector<double> rho(static_cast<std::size_t>(rows()));
  rho[static_cast<std::size_t>(place)] = sign;
  if (!solve_with_transposed_basis(rho)) return {};
  return rho;
}

std::pair<int, double> Simplex::contradicting() {
  std::pair<int, double> found{-1, 0};
  if (status_ != LinearStatus::infeasible || empty_bounds() || !factorised()) return found;
  problem_->call([&] {
    auto* const lp = problem_->get();
    const int ray = glp_get_unbnd_ray(lp);
    if (ray == 0) return;
    const bool is_row = ray <= rows();
    const int k = is_row ? ray : ray - rows();
    const int place = is_row ? glp_get_row_bind(lp, k) : glp_get_col_bind(lp, k);
    if (place == 0) return;
    const double at = is_row ? glp_get_row_prim(lp, k) : glp_get_col_prim(lp, k);
    const double lower = is_row ? glp_get_row_lb(lp, k) : glp_get_col_lb(lp, k);
    const bool has_lower = (is_row ? glp_get_row_type(lp, k) : glp_get_col_type(lp, k)) != GLP_UP;
    found = {place - 1, has_lower && at < lower ? 1.0 : -1.0};
  });
  return found;
}

// A trivial program, for example without entries, is solved without a factorisation.
bool Simplex::factorised() {
  bool there = rows() == 0;
  if (there) return true;
  problem_->call(
      [&] { there = glp_bf_exists(problem_->get()) != 0 || glp_factorize(problem_->get()) == 0; });
  return there;
}

std::vector<int> Simplex::basis_head() {
  if (!factorised()) return {};
  std::vector<int> head;
  for (int place = 1; place <= rows(); ++place) {
    head.push_back(glp_get_bhead(problem_->get(), place) - 1);
  }
  return head;
}

bool Simplex::solve_with_basis(std::vector<double>& b) {
  const bool there = factorised();
  if (there) problem_->solve(glp_ftran, b);
  return there;
}

bool Simplex::solve_with_transposed_basis(std::vector<double>& b) {
  const bool there = factorised();
  if (there) problem_->solve(glp_btran, b);
  return there;
}

}  // namespace kusabi::linear
