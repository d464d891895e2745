// Interior-point iteration. The header states the pair of programs.
#include "solvers/conic/interior_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solvers/conic/iteration_rules.hpp"

namespace kusabi::conic {

namespace {

// Product of the columns of one cone of A with a matrix, by columns. `rows` and `distance` are
// those of A, from one component to the next, and the same for the product.
template <int D, class Real>
KUSABI_INLINE void multiply_columns(const Real* a, int distance, int rows,
                                    const Eigen::Matrix<Real, D, D>& matrix, Real* product,
                                    int product_distance) {
  for (int row = 0; row < rows; row += lanes<Real>) {
    ConePoint<D, Packed<Real>> entries;
    for (int d = 0; d < D; ++d) entries[static_cast<std::size_t>(d)] = load(a + d * distance + row);
    for (int d = 0; d < D; ++d) {
      ConePoint<D, Packed<Real>> column;
      for (int e = 0; e < D; ++e) column[static_cast<std::size_t>(e)] = matrix(e, d);
      store(product + d * product_distance + row, dot(entries, column));
    }
  }
}

}  // namespace

template <int D, class Real>
InteriorPoint<D, Real>::InteriorPoint(const Program& program)
    : elimination_(program.first_cut(), program.max_cuts(), program.max_cones()),
      normal_equations_(program.first_cut() + (program.max_cuts() > 0 ? 1 : 0)) {
  const Eigen::Index rows = padded<Real>(program.max_rows());
  const int motions = program.motions().lifting;
  reduced_modes_.setZero(padded<Real>(motions), rows);
  along_motion_.setZero(rows);
  motion_.setZero(motions);
  // the constructor allocates; solvers are copied with their state
  schur_.compute(MatrixOf<Real>::Identity(motions, motions));
  const Eigen::Index cones = padded<Real>(program.max_cones());
  for (Points* points : {&x_, &z_, &projected_, &step_x_, &step_z_, &products_})
    points->setZero(cones, D);
  for (Vector* numbers : {&v_, &y_, &w_, &weights_, &lambda_, &predictor_, &correction_, &dy_,
                          &trial_, &step_v_, &step_y_})
    numbers->setZero(rows);
  present_.setZero(cones);
  scaling_.resize(static_cast<std::size_t>(cones / width));
  const Eigen::Index left = padded<Real>(program.first_cut() + 1);
  for (Vector* numbers : {&reduced_first_, &reduced_second_, &along_}) numbers->setZero(left);
  scaled_matrix_.setZero(left * D * cones);
  faces_.setZero((D + 1) * width, left);
}

template <int D, class Real>
KUSABI_INLINE auto InteriorPoint<D, Real>::load_cones(const Points& points, int cone) -> Cones {
  Cones values;
  for (std::size_t d = 0; d < values.size(); ++d)
    values[d] = load(points.data() + static_cast<Eigen::Index>(d) * points.rows() + cone);
  return values;
}

template <int D, class Real>
KUSABI_INLINE void InteriorPoint<D, Real>::store_cones(Points& points, int cone,
                                                       const Cones& values) {
  for (std::size_t d = 0; d < values.size(); ++d)
    store(points.data() + static_cast<Eigen::Index>(d) * points.rows() + cone, values[d]);
}

template <int D, class Real>
void InteriorPoint<D, Real>::start(const Program& program) {
  const auto count = static_cast<int>(program.cones().size());
  elimination_.start(program);
  normal_equations_.resize(elimination_.is_needed() ? elimination_.rows() : program.rows());
  for (Vector* numbers : {&predictor_, &correction_, &dy_, &trial_, &step_v_, &step_y_})
    numbers->setZero();  // rows not used by this node
  y_ = program.slack();
  program.multiply_transposed(y_, products_);
  double size = start_limit;
  for (int c = 0; c < count; ++c) {
    ConePoint<D, Real> push;
    for (std::size_t d = 0; d < push.size(); ++d)
      push[d] = products_(c, static_cast<Eigen::Index>(d));
    const double outward = numbers::rounded(Real(push[0] + radius(push)));
    if (outward * size > start_share) size = start_share / outward;
  }
  y_ *= Real(size);
  x_.setZero();
  x_.col(0).setConstant(Real(start_point / static_cast<double>(count)));
  v_ = Real(start_slack / static_cast<double>(count)) * program.slack();
  motion_.setZero(program.free_columns().cols());
  present_.setZero();
  present_.head(count).setOnes();
  refresh_dual(program, y_);
}

template <int D, class Real>
template <class Shorter>
bool InteriorPoint<D, Real>::start_from(const InteriorPoint<D, Shorter>& other,
                                        const NodeProgram<D, Shorter>& other_program,
                                        const Program& program) {
  start(program);
  const auto count = static_cast<Eigen::Index>(program.cones().size());
  const Eigen::Index rows = program.rows();
  VectorOf<Shorter> forces = other.y_;
  other_program.to_multipliers(forces);
  Vector y = Vector::Zero(y_.size());
  y.head(rows) = forces.head(rows).template cast<Real>();
  program.from_multipliers(y);
  const Real share = start_towards_centre;
  y_ += (1.0 - share) * (y - y_);
  x_.topRows(count) +=
      (1.0 - share) * (other.x_.topRows(count).template cast<Real>() - x_.topRows(count));
  v_.head(rows) += (1.0 - share) * (other.v_.head(rows).template cast<Real>() - v_.head(rows));
  auto inside = Packed<Real>(1.0) > Packed<Real>(0.0);
  for (Eigen::Index c = 0; c < count; c += width)
    inside &= margin(load_cones(x_, static_cast<int>(c))) > Packed<Real>(0.0);
  for (int i = 0; i < program.rows(); i += width)
    inside &= where(program.slack().data() + i, load(v_.data() + i), 1.0) > Packed<Real>(0.0);
  return refresh_dual(program, y_) && all(inside);
}

template <int D, class Real>
bool InteriorPoint<D, Real>::refresh_dual(const Program& program, const Vector& y) {
  const auto count = static_cast<int>(program.cones().size());
  program.multiply_transposed(y, products_);
  auto inside = Packed<Real>(1.0) > Packed<Real>(0.0);
  for (int c = 0; c < count; c += width) {
    Cones z = load_cones(products_, c);
    z[0] = 1.0 - z[0];
    for (std::size_t d = 1; d < z.size(); ++d) z[d] = -z[d];
    store_cones(z_, c, z);
    inside &= margin(z) > Packed<Real>(0.0);
  }
  for (int i = 0; i < program.rows(); i += width)
    inside &= where(program.slack().data() + i, load(y.data() + i), 1.0) > Packed<Real>(0.0);
  return all(inside);
}

template <int D, class Real>
Real InteriorPoint<D, Real>::scale(const Program& program) {
  const auto count = static_cast<int>(program.cones().size());
  Packed<Real> widest = {}, product_sum = {};
  for (int c = 0; c < count; c += width) {
    const Scaling scaling(load_cones(x_, c), load_cones(z_, c));
    scaling_[static_cast<std::size_t>(c / width)] = scaling;
    const Cones lambda = scaling.lambda();
    const Packed<Real> present = load(present_.data() + c);
    widest = larger(widest, scaling.entry(0, 0) * present);
    product_sum += dot(lambda, lambda) * present;
  }
  program.multiply(x_, trial_);
  for (int i = 0; i < program.rows(); i += width) {
    const Packed<Real> v = load(v_.data() + i), y = load(y_.data() + i);
    const Real* slack = program.slack().data() + i;
    const Packed<Real> point = where(slack, root(v * y), 1.0);
    product_sum += where(slack, v * y, 0.0);
    store(w_.data() + i, where(slack, root(v / y), 0.0));
    store(lambda_.data() + i, point);
    const Packed<Real> b = load(program.right_side().data() + i);
    store(predictor_.data() + i, b);
    store(correction_.data() + i, b + v - load(trial_.data() + i));
  }
  complementarity_ = total(product_sum);
  return largest(widest);
}

template <int D, class Real>
PackedColumns<Real> InteriorPoint<D, Real>::scaled_columns(const Program& program) const {
  PackedColumns<Real> columns = program.matrix();
  columns.data = scaled_matrix_.data();
  if (elimination_.is_needed()) columns.rows = padded<Real>(elimination_.rows());
  return columns;
}

template <int D, class Real>
auto InteriorPoint<D, Real>::matrix_of(int cone) const -> Square {
  const auto& scaling = this->scaling(cone);
  Square matrix;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      matrix(i, j) = in_lane(
          scaling.entry(static_cast<std::size_t>(i), static_cast<std::size_t>(j)), cone % width);
  return matrix;
}

template <int D, class Real>
void InteriorPoint<D, Real>::scale_matrix(const Program& program) {
  const PackedColumns<Real> from = program.matrix();
  const PackedColumns<Real> to = scaled_columns(program);
  const int distance = from.stride * from.rows;
  const int scaled_distance = to.stride * to.rows;
  for (int c = 0; c < from.count; ++c) {
    Real* const scaled = scaled_matrix_.data() + Eigen::Index{c} * to.rows;
    const Real* const columns = from.data + Eigen::Index{c} * from.rows;
    if (!elimination_.is_needed()) {
      multiply_columns<D, Real>(columns, distance, from.rows, matrix_of(c), scaled,
                                scaled_distance);
      continue;
    }
    const auto share = elimination_.share(c, matrix_of(c));
    multiply_columns<D, Real>(columns, distance, from.rows, share.root, scaled, scaled_distance);
    for (int d = 0; d < D; ++d) {
      Real* const column = scaled + Eigen::Index{d} * scaled_distance;
      if (to.rows > from.rows) store(column + from.rows, Packed<Real>(0.0));
      column[elimination_.rows() - 1] = share.root(0, d);
      column[share.row] += share.in_row[d];
    }
  }
}

template <int D, class Real>
bool InteriorPoint<D, Real>::factorise(const Program& program) {
  const Real widest = scale(program);
  if (elimination_.is_needed()) elimination_.begin(w_);
  scale_matrix(program);
  normal_equations_.assemble(scaled_columns(program));
  weights_.head(program.first_cut()) = w_.head(program.first_cut()).cwiseAbs2();
  if (elimination_.is_needed()) {
    if (!elimination_.border(program)) return false;
    elimination_.complete(weights_, normal_equations_);
  }
  const double shift = shift_of_diagonal<Real>(program.rows());
  // The shift is relative per row, since rows of stiff candidates are small.
  for (int i = 0; i < program.first_cut(); ++i) {
    const Real b = program.right_side()[i];
    const Real size = normal_equations_.diagonal(i) + widest * widest * b * b;
    normal_equations_.add_to_diagonal(i, shift * size + weights_[i]);
  }
  // Empty rows are like the padding.
  for (const int i : program.empty_rows()) normal_equations_.add_to_diagonal(i, Real(1));
  if (motion_.size() == 0) {
    if (!factorise_and_solve()) return false;
  } else {
    const Vector unbalanced = regularise_modes(program);
    if (!factorise_and_solve() || !solve_modes(program, unbalanced)) return false;
  }
  return !extended<Real> ||
         std::isfinite(numbers::rounded(Real(predictor_.sum() + correction_.sum())));
}

template <int D, class Real>
bool InteriorPoint<D, Real>::factorise_and_solve() {
  if (!elimination_.is_needed())
    return normal_equations_.factorise(predictor_.data(), correction_.data());
  elimination_.reduce(predictor_, reduced_first_);
  elimination_.reduce(correction_, reduced_second_);
  if (!normal_equations_.factorise(reduced_first_.data(), reduced_second_.data())) return false;
  elimination_.expand(reduced_first_, predictor_);
  elimination_.expand(reduced_second_, correction_);
  return true;
}

template <int D, class Real>
void InteriorPoint<D, Real>::solve(Vector& whole) {
  if (!elimination_.is_needed()) return normal_equations_.solve(whole.data());
  elimination_.reduce(whole, reduced_first_);
  normal_equations_.solve(reduced_first_.data());
  elimination_.expand(reduced_first_, whole);
}

template <int D, class Real>
auto InteriorPoint<D, Real>::regularise_modes(const Program& program) -> Vector {
  const MatrixOf<Real>& columns = program.free_columns();
  // Size of the rows of U; rows with a slack only grow.
  Real size = 0;
  for (int i = 0; i < program.first_cut(); ++i) size += normal_equations_.diagonal(i) - weights_[i];
  const Real weight = size / columns.squaredNorm();
  // The contribution of the cuts' rows to the columns is eliminated.
  const auto count = program.first_cut();
  along_.setZero();
  for (Eigen::Index l = 0; l < columns.cols(); ++l) {
    along_.head(count) = columns.col(l).head(count);
    normal_equations_.add_square(along_.data(), weight);
  }
  const Vector unbalanced = columns.transpose() * y_.head(columns.rows());
  predictor_.head(columns.rows()) -= weight * (columns * unbalanced);
  return unbalanced;
}

// With M = L L', S = (L^-1 H)'(L^-1 H). With cuts, L is the factor of the equations without their
// rows, and each column of H is reduced and expanded as a right side.
template <int D, class Real>
bool InteriorPoint<D, Real>::factorise_schur(const Program& program) {
  const MatrixOf<Real>& columns = program.free_columns();
  const Eigen::Index p = columns.cols();
  if (elimination_.is_needed()) {
    MatrixOf<Real> solved(columns.rows(), p);
    trial_.setZero();
    for (Eigen::Index l = 0; l < p; ++l) {
      trial_.head(columns.rows()) = columns.col(l);
      solve(trial_);
      solved.col(l) = trial_.head(columns.rows());
    }
    schur_.compute(columns.transpose() * solved);
  } else {
    reduced_modes_.setZero(padded<Real>(static_cast<int>(p)), columns.rows());
    reduced_modes_.topRows(p) = columns.transpose();
    normal_equations_.reduce(reduced_modes_.data(), static_cast<int>(reduced_modes_.rows()));
    const auto own = reduced_modes_.topRows(p);
    schur_.compute(own * own.transpose());
  }
  return schur_.info() == Eigen::Success;
}

template <int D, class Real>
bool InteriorPoint<D, Real>::solve_modes(const Program& program, const Vector& unbalanced) {
  if (!factorise_schur(program)) return false;
  motion_ = balance(program, correction_);
  balance(program, predictor_);
  subtract(program, schur_.solve(unbalanced), predictor_);
  return true;
}

template <int D, class Real>
auto InteriorPoint<D, Real>::balance(const Program& program, Vector& solution) -> Vector {
  const MatrixOf<Real>& columns = program.free_columns();
  const Vector motion = schur_.solve(columns.transpose() * solution.head(columns.rows()));
  subtract(program, motion, solution);
  return motion;
}

template <int D, class Real>
void InteriorPoint<D, Real>::subtract(const Program& program, const Vector& motion,
                                      Vector& solution) {
  const MatrixOf<Real>& columns = program.free_columns();
  along_motion_.setZero();
  along_motion_.head(columns.rows()) = columns * motion;
  solve(along_motion_);
  solution.head(columns.rows()) -= along_motion_.head(columns.rows());
}

template <int D, class Real>
auto InteriorPoint<D, Real>::project(const Program& program) -> const Points& {
  projected_ = x_;
  shift_projected(program, correction_);
  return projected_;
}

template <int D, class Real>
auto InteriorPoint<D, Real>::solve_residual(const Vector& discrepancy, const Program& program)
    -> Vector {
  trial_ = discrepancy;
  solve(trial_);
  return motion_.size() > 0 ? balance(program, trial_) : Vector();
}

template <int D, class Real>
auto InteriorPoint<D, Real>::project_again(const Vector& discrepancy, const Program& program)
    -> const Points& {
  const Vector motion = solve_residual(discrepancy, program);
  if (motion_.size() > 0) motion_ += motion;
  shift_projected(program, trial_);
  return projected_;
}

template <int D, class Real>
auto InteriorPoint<D, Real>::correction(const Vector& discrepancy, const Program& program,
                                        Vector& motion) -> const Points& {
  motion = solve_residual(discrepancy, program);
  projected_.setZero();
  shift_projected(program, trial_);
  return projected_;
}

template <int D, class Real>
void InteriorPoint<D, Real>::shift_projected(const Program& program, const Vector& weights) {
  const auto count = static_cast<int>(program.cones().size());
  program.multiply_transposed(weights, products_);
  for (int c = 0; c < count; c += width) {
    const Cones shift = scaling(c).times(scaling(c).times(load_cones(products_, c)));
    Cones point = load_cones(projected_, c);
    for (std::size_t d = 0; d < point.size(); ++d) point[d] += shift[d];
    store_cones(projected_, c, point);
  }
}

template <int D, class Real>
auto InteriorPoint<D, Real>::directions(const Program& program, const Vector& dy)
    -> InverseStepLengths {
  const auto count = static_cast<int>(program.cones().size());
  program.multiply_transposed(dy, products_);
  Packed<Real> dual = {}, primal = {};
  for (int c = 0; c < count; c += width) {
    const Scaling& scaling = this->scaling(c);
    const Cones lambda = scaling.lambda();
    const Packed<Real> present = load(present_.data() + c);
    Cones dz = scaling.times(load_cones(products_, c));
    Cones dx = load_cones(step_x_, c);
    for (std::size_t d = 0; d < dz.size(); ++d) {
      dz[d] = -dz[d];
      dx[d] = (dx[d] - lambda[d] - dz[d]) * present;
    }
    store_cones(step_z_, c, dz);
    store_cones(step_x_, c, dx);
    dual = larger(dual, scaling.inverse_step_length(dz));
    primal = larger(primal, scaling.inverse_step_length(dx));
  }
  for (int i = 0; i < program.rows(); i += width) {
    const Real* slack = program.slack().data() + i;
    const Packed<Real> change = load(dy.data() + i);
    const Packed<Real> point = load(lambda_.data() + i);
    const Packed<Real> step_y = load(w_.data() + i) * change;
    const Packed<Real> step_v = where(slack, load(step_v_.data() + i) - point - step_y, 0.0);
    store(step_y_.data() + i, step_y);
    store(step_v_.data() + i, step_v);
    dual = larger(dual, -step_y / point);
    primal = larger(primal, -step_v / point);
  }
  return {largest(dual), largest(primal)};
}

template <int D, class Real>
void InteriorPoint<D, Real>::correct(const Program& program, Real sigma_nu, Real affine_length) {
  const auto count = static_cast<int>(program.cones().size());
  for (int c = 0; c < count; c += width) {
    Cones right_side = jordan_product(load_cones(step_x_, c), load_cones(step_z_, c));
    for (Packed<Real>& component : right_side) component *= -affine_length;
    right_side[0] += sigma_nu;
    const Cones q = scaling(c).jordan_divide(right_side);
    store_cones(step_x_, c, q);
    store_cones(products_, c, scaling(c).times(q));
  }
  program.multiply(products_, trial_);
  for (int i = 0; i < program.rows(); i += width) {
    const Packed<Real> q =
        (sigma_nu - affine_length * load(step_v_.data() + i) * load(step_y_.data() + i)) /
        load(lambda_.data() + i);
    store(step_v_.data() + i, q);
    store(trial_.data() + i, load(trial_.data() + i) - load(w_.data() + i) * q);
  }
}

template <int D, class Real>
bool InteriorPoint<D, Real>::advance(const Program& program) {
  // Predictor: W^-1 dx + W dz = -lambda and A dx = b - A x reduce to M dy = b.
  step_x_.setZero();
  step_v_.setZero();
  const InverseStepLengths predicted = directions(program, predictor_);
  const Real affine_length = 1.0 / std::max({Real(1), predicted.dual, predicted.primal});

  // Corrector: W^-1 dx + W dz = -lambda + q with lambda o q = sigma nu e - alpha dx~ o dz~, alpha
  // the length of the predictor's step, and A dx = (1 - sigma) (b - A x), hence M dy = b - sigma (b
  // - A x) - B q. Mehrotra's method has the second-order term without the factor alpha; after a
  // short predictor step that term is too large, and the iteration can cycle.
  const auto degree = static_cast<double>(program.cones().size() + program.slacks());
  const Real rest = 1.0 - affine_length;
  const Real sigma = rest * rest * rest;
  correct(program, sigma * complementarity_ / degree, affine_length);
  solve(trial_);
  if (motion_.size() > 0) balance(program, trial_);
  dy_ = predictor_ - trial_ - sigma * correction_;
  const InverseStepLengths corrected = directions(program, dy_);
  const Real dual_length = step_length(boundary_fraction, corrected.dual);
  const Real primal_length = step_length(boundary_fraction, corrected.primal);
  return std::max(primal_length, dual_length) > min_step_length &&
         move_primal(program, primal_length) && move_dual(program, dual_length);
}

template <int D, class Real>
auto InteriorPoint<D, Real>::centring_step(const Program& program, Real complementarity) -> Step {
  for (Points* points : {&step_x_, &step_z_}) points->setZero();
  correct(program, complementarity, Real(0));
  solve(trial_);
  dy_ = predictor_ - trial_;
  const InverseStepLengths lengths = directions(program, dy_);
  const Real dual_length = step_length(centring_fraction, lengths.dual);
  const Real primal_length = step_length(centring_fraction, lengths.primal);
  if (!move_primal(program, primal_length) || !move_dual(program, dual_length)) return Step::failed;
  return std::min(primal_length, dual_length) < 1 ? Step::shortened : Step::full;
}

template <int D, class Real>
bool InteriorPoint<D, Real>::centre(const Program& program, Real complementarity) {
  int full = 0;  // a second full step is accurate enough
  for (int step = 0; step < max_centring_steps && full < 2; ++step) {
    const Step made = centring_step(program, complementarity);
    if (made == Step::failed || !factorise(program)) return false;
    if (made == Step::full) ++full;
  }
  return true;
}

template <int D, class Real>
auto InteriorPoint<D, Real>::face_rows(const Program& program, int cone, int first_row) ->
    typename CutElimination<D, Real>::Part {
  const int candidate = program.cones()[static_cast<std::size_t>(cone)];
  const PackedColumns<Real> matrix = program.matrix();
  const Square scaling = matrix_of(cone);
  auto rows = faces_.middleRows(first_row, D + 1);
  rows.setZero();
  for (int e = 0; e < D; ++e) {
    const Eigen::Map<const Eigen::Matrix<Real, 1, Eigen::Dynamic>> column(
        matrix.data + Eigen::Index{e * matrix.stride + cone} * matrix.rows, matrix.rows);
    for (int d = 0; d < D; ++d) rows.row(d).head(matrix.rows) += scaling(e, d) * column;
  }
  rows(D, candidate) = w_[candidate];
  if (!elimination_.is_needed()) return {};
  const auto part = elimination_.part_of(candidate, along_);
  const Eigen::Index height = padded<Real>(elimination_.rows());
  for (int d = 0; d < D; ++d) {
    rows(d, elimination_.rows() - 1) = scaling(0, d);
    rows.row(d).head(height) -= part.cone[d] * along_.head(height).transpose();
  }
  rows.row(D).head(height) += part.slack * along_.head(height).transpose();
  return part;
}

// The squared length of a direction is ||W^-1 dx||^2 + ||dv / w||^2: on the central path nu times
// the second derivative of the barrier. Among those with A dx = dv, the shortest with dx_i = -x_i
// has the length lambda_i'(I - B_i'M^-1 B_i)^-1 lambda_i, and the shortest with dv_i = -v_i has the
// length lambda_i^2 / (1 - w_i^2 (M^-1)_ii).
template <int D, class Real>
void InteriorPoint<D, Real>::measure_faces(const Program& program,
                                           std::vector<FaceDistances>& distances) {
  // Below this, the distance of a face is limited by rounding only.
  constexpr double minimum = 1e-14;
  constexpr int height = D + 1;  // rows of a cone among the reduced ones, and one of its slack
  const int rows = scaled_columns(program).rows;
  std::array<typename CutElimination<D, Real>::Part, static_cast<std::size_t>(width)> parts;
  const auto& cones = program.cones();
  const auto count = static_cast<int>(cones.size());
  for (auto& distance : distances) distance = {};
  for (int first = 0; first < count; first += width) {
    const int present = std::min(width, count - first);
    faces_.leftCols(rows).setZero();
    for (int lane = 0; lane < present; ++lane)
      parts[static_cast<std::size_t>(lane)] = face_rows(program, first + lane, lane * height);
    normal_equations_.reduce(faces_.data(), static_cast<int>(faces_.rows()));
    const Cones lambdas = scaling(first).lambda();
    for (int lane = 0; lane < present; ++lane) {
      const auto row = cones[static_cast<std::size_t>(first + lane)];
      if (program.slack()[row] == 0) continue;
      const auto own = faces_.middleRows(lane * height, D).leftCols(rows);
      const auto& part = parts[static_cast<std::size_t>(lane)];
      Square rest = -own * own.transpose() - part.weight * part.cone * part.cone.transpose();
      Eigen::Matrix<double, D, 1> lambda;
      for (int d = 0; d < D; ++d) {
        rest(d, d) += Real(1 + minimum);
        lambda[d] = numbers::rounded(in_lane(lambdas[static_cast<std::size_t>(d)], lane));
      }
      const Real slack = 1.0 - faces_.row(lane * height + D).head(rows).squaredNorm() -
                         part.weight * part.slack * part.slack;
      distances[static_cast<std::size_t>(row)] = {
          .separation = lambda.dot(rest.template cast<double>().ldlt().solve(lambda)),
          .contact =
              numbers::rounded(Real(lambda_[row] * lambda_[row] / std::max(slack, Real(minimum))))};
    }
  }
}

template <int D, class Real>
bool InteriorPoint<D, Real>::move_primal(const Program& program, Real step_length) {
  const auto count = static_cast<int>(program.cones().size());
  auto inside = Packed<Real>(1.0) > Packed<Real>(0.0);
  for (int c = 0; c < count; c += width) {
    const Cones change = scaling(c).times(load_cones(step_x_, c));
    Cones x = load_cones(x_, c);
    for (std::size_t d = 0; d < x.size(); ++d) x[d] += step_length * change[d];
    store_cones(x_, c, x);
    inside &= margin(x) > Packed<Real>(0.0);
  }
  for (int i = 0; i < program.rows(); i += width) {
    const Packed<Real> change = load(w_.data() + i) * load(step_v_.data() + i);
    const Packed<Real> v = load(v_.data() + i) + step_length * change;
    store(v_.data() + i, v);
    inside &= where(program.slack().data() + i, v, 1.0) > Packed<Real>(0.0);
  }
  return all(inside);
}

template <int D, class Real>
bool InteriorPoint<D, Real>::move_dual(const Program& program, Real step_length) {
  for (int halving = 0; halving <= max_halvings; ++halving, step_length /= 2) {
    trial_ = y_ + step_length * dy_;
    if (refresh_dual(program, trial_)) {
      y_.swap(trial_);
      return true;
    }
  }
  return false;
}

template class InteriorPoint<2, double>;
template class InteriorPoint<3, double>;
template class InteriorPoint<2, long double>;
template class InteriorPoint<3, long double>;
template class InteriorPoint<2, numbers::Precise>;
template class InteriorPoint<3, numbers::Precise>;
#define KUSABI_START_FROM(D, Real, Shorter)                                                \
  template bool InteriorPoint<D, Real>::start_from(const InteriorPoint<D, Shorter>& other, \
                                                   const NodeProgram<D, Shorter>& from,    \
                                                   const Program& program)
KUSABI_START_FROM(2, long double, double);
KUSABI_START_FROM(3, long double, double);
KUSABI_START_FROM(2, numbers::Precise, long double);
KUSABI_START_FROM(3, numbers::Precise, long double);
#undef KUSABI_START_FROM

}  // namespace kusabi::conic
