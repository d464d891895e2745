// Assembly of the standard form of a node program. The header states it.
#include "solvers/conic/node_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "solvers/conic/pack.hpp"

namespace kusabi::conic {

using support::IndexSet;

namespace {

// Permitted asymmetry of a compliance, relative to its largest entry: large enough for the rounding
// of an inverted stiffness, small enough to detect a missing row.
constexpr double symmetry_tolerance = 1e-8;

// Beyond these limits a cone is nearly a ray or a half-space, and no tolerance is suitable. The
// margin allows for rounded products of factors and coefficients, and for circumscribed polygons.
constexpr double min_friction = 1e-6 * (1 - 1e-12);
constexpr double max_friction = 1.5e6;

std::string in_short(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

std::vector<int> one_each(std::size_t candidates) {
  std::vector<int> owners(candidates);
  std::iota(owners.begin(), owners.end(), 0);
  return owners;
}

void check(std::span<const double> friction) {
  for (const double mu : friction)
    if (mu != 0 && !(mu >= min_friction && mu <= max_friction))
      throw std::invalid_argument("a friction coefficient is " + in_short(mu) +
                                  "; expected 0, or a number from 1e-6 to 1e6");
}

void check(const Eigen::MatrixXd& compliance, std::span<const double> friction,
           const std::vector<int>& owners, int d) {
  if (owners.size() != friction.size())
    throw std::invalid_argument("every cone needs a candidate and a friction coefficient");
  for (std::size_t k = 0; k < owners.size(); ++k) {
    const int before = k == 0 ? -1 : owners[k - 1];
    if ((k == 0 || owners[k] != before) && owners[k] != before + 1)
      throw std::invalid_argument("cones must be ordered by their candidates, none left out");
  }
  const std::size_t m = owners.empty() ? 0 : static_cast<std::size_t>(owners.back()) + 1;
  if (m < 1) throw std::invalid_argument("a node program takes contact candidates; there are none");
  const auto size = static_cast<Eigen::Index>(owners.size()) * d;
  if (compliance.rows() != size || compliance.cols() != size)
    throw std::invalid_argument(
        "the compliance must be " + std::to_string(size) + " x " + std::to_string(size) + ", not " +
        std::to_string(compliance.rows()) + " x " + std::to_string(compliance.cols()));
  if (!compliance.allFinite() || !(compliance.diagonal().array() > 0).all())
    throw std::invalid_argument("the compliance must be finite with a positive diagonal");
  const double largest = compliance.cwiseAbs().maxCoeff();
  if ((compliance - compliance.transpose()).cwiseAbs().maxCoeff() > symmetry_tolerance * largest)
    throw std::invalid_argument("the compliance must be symmetric");
  check(friction);
}

}  // namespace

template <int D, class Real>
NodeProgram<D, Real>::NodeProgram(const Matrix& compliance, std::span<const double> friction)
    : NodeProgram(compliance, friction, one_each(friction.size())) {}

template <int D, class Real>
NodeProgram<D, Real>::NodeProgram(const Matrix& compliance, std::span<const double> friction,
                                  std::vector<int> owners, Motions<Real> motions, int loads)
    : motions_(std::move(motions)),
      friction_(friction.begin(), friction.end()),
      owners_(std::move(owners)),
      padded_cones_(padded<Real>(this->max_cones())),
      loads_(loads) {
  check(compliance.template cast<double>(), friction, owners_, D);
  if (motions_.count() > 0 && motions_.at_cones.rows() != compliance.rows())
    throw std::invalid_argument("the motions must have as many rows as the compliance");
  const int m = owners_.back() + 1;
  const int all_rows = m + motions_.count();
  compliance_ = compliance;
  normal_compliance_.setZero(padded<Real>(all_rows),
                             padded<Real>(static_cast<int>(compliance.cols())));
  normal_motions_.setZero(padded<Real>(all_rows), motions_.lifting);
  for (std::size_t k = 0; k < owners_.size(); ++k)
    normal_compliance_.row(owners_[k]).head(compliance.cols()) =
        compliance.row(D * static_cast<Eigen::Index>(k));
  for (Eigen::Index l = 0; l < motions_.count(); ++l) {
    normal_compliance_.row(m + l).head(compliance.cols()) = motions_.at_cones.col(l).transpose();
    if (l >= motions_.lifting) continue;
    for (std::size_t k = 0; k < owners_.size(); ++k)
      normal_motions_(owners_[k], l) = motions_.at_cones(D * static_cast<Eigen::Index>(k), l);
  }
  make_room(0);
  pull_.setZero(normal_compliance_.cols());
  forces_.setZero(normal_compliance_.rows());
  cones_.reserve(friction.size());
  gap_rows_.reserve(static_cast<std::size_t>(m));
  contact_rows_.reserve(static_cast<std::size_t>(m));
}

template <int D, class Real>
void NodeProgram<D, Real>::make_room(int max_cuts) {
  max_cuts_ = max_cuts;
  cuts_.reserve(static_cast<std::size_t>(max_cuts));
  cut_rows_.reserve(static_cast<std::size_t>(max_cuts));
  const Eigen::Index room = padded<Real>(max_rows());
  matrix_.setZero(padded<Real>(first_cut()) * D * padded_cones_);
  right_side_.setZero(room);
  slack_.setZero(room);
  gap_.setZero(room);
}

template <int D, class Real>
void NodeProgram<D, Real>::set_friction(std::span<const double> friction) {
  if (friction.size() != friction_.size())
    throw std::invalid_argument("every cone needs a friction coefficient");
  check(friction);
  std::copy(friction.begin(), friction.end(), friction_.begin());
}

template <int D, class Real>
void NodeProgram<D, Real>::select(const IndexSet& contact, const IndexSet& separated,
                                  const IndexSet& ignored, std::span<const Cut> cuts,
                                  const IndexSet& lifted) {
  const int m = candidates();
  const IndexSet without_reaction = separated | ignored;
  if (contact.meets(separated))
    throw std::invalid_argument("a candidate is both in contact and separated");
  if (ignored.meets(contact | separated))
    throw std::invalid_argument("a candidate is ignored and has a sign");
  if (!IndexSet::below(m - loads_).includes(contact | without_reaction))
    throw std::invalid_argument("a sign pattern names a candidate that does not exist");
  if (static_cast<int>(cuts.size()) > max_cuts_)
    throw std::invalid_argument("there are more cuts than there is room for");

  cones_.clear();
  gap_rows_.clear();
  contact_rows_.clear();
  contact_ = contact;
  ignored_ = loads_ == 0 ? ignored : ignored | (IndexSet::below(m) - IndexSet::below(m - loads_));
  cuts_.assign(cuts.begin(), cuts.end());
  omega_ = Real(0);
  for (std::size_t k = 0; k < friction_.size(); ++k) {
    if (without_reaction.contains(owners_[k])) continue;
    cones_.push_back(static_cast<int>(k));
    omega_ += level_weight<Real>(friction_[k]);
  }
  for (int i = 0; i < m; ++i) {
    if (!ignored_.contains(i)) (contact.contains(i) ? contact_rows_ : gap_rows_).push_back(i);
  }
  empty_rows_ = ignored_ | lifted;
  if (cones_.empty()) return;  // the standard form is empty, since no r sums to one
  if (is_reduced()) reduce_modes();

  // Row i of the node program, with r_n = x_0 + t / mu and r_t = mu x_1, and t eliminated:
  //   sum_C [F_nn, mu F_nt] x + g t - v = 0,  g = sum_C F_nn / mu - [i not in U],
  //   t = (1 - sum x_0) / omega.
  right_side_.setZero();
  auto whole = right_side_.head(normal_compliance_.rows());
  for (const int k : cones_)
    whole +=
        level_weight<Real>(friction_[static_cast<std::size_t>(k)]) * normal_compliance_.col(D * k);
  to_rows(right_side_);
  slack_.setZero();
  slacks_ = cuts_.size();
  for (const int j : gap_rows_) {
    if (empty_rows_.contains(j)) continue;
    slack_[j] = Real(1);
    ++slacks_;
  }
  whole -= slack_.head(whole.size());
  right_side_ /= -omega_;
  for (const int i : empty_rows_) right_side_[i] = Real(0);
  fill_columns();
  fill_cuts();
}

template <int D, class Real>
std::vector<int> NodeProgram<D, Real>::candidates_with_row() const {
  std::vector<int> with;
  for (int i = 0; i < candidates(); ++i)
    if (!empty_rows_.contains(i)) with.push_back(i);
  return with;
}

// Modes invisible in the rows would give zero columns, and redundant equations, which on few cones
// read 0 = 0, multipliers that drift. A mode that is tangential at all of these candidates, up to
// rounding, is invisible even if it separates others.
template <int D, class Real>
void NodeProgram<D, Real>::reduce_modes() {
  Matrix seen = normal_motions_(candidates_with_row(), Eigen::all);
  motion_basis_ = Matrix::Identity(seen.cols(), seen.cols());
  const double largest = largest_displacement(motions_.at_cones, Eigen::Index{D} * loads_);
  const Eigen::Index visible = eliminate(seen, motion_basis_, 1, negligible_mode, largest).pivots;
  motion_basis_.conservativeResize(Eigen::NoChange, visible);

  const Eigen::Index p = motions_.count();
  Matrix effective(D * static_cast<Eigen::Index>(cones_.size()), p);
  Eigen::Index row = 0;
  for (const int k : cones_) {
    effective.template middleRows<D>(row) = motions_.at_cones.template middleRows<D>(D * k);
    effective.template middleRows<D - 1>(row + 1) *= Real(friction_[static_cast<std::size_t>(k)]);
    row += D;
  }
  equation_basis_ = Matrix::Identity(p, p);
  const Eigen::Index independent = eliminate(effective, equation_basis_, 1, negligible_mode).pivots;
  equation_basis_.rightCols(p - independent).setZero();
  for (Eigen::Index l = independent; l < p; ++l)
    empty_rows_.insert(candidates() + static_cast<int>(l));
}

template <int D, class Real>
void NodeProgram<D, Real>::from_multipliers(Vector& y) const {
  if (!is_reduced()) return;
  const Eigen::MatrixXd basis = equation_basis_.template cast<double>();
  const Eigen::VectorXd own = Vector(of_modes(y)).template cast<double>();
  of_modes(y) = basis.completeOrthogonalDecomposition().solve(own).template cast<Real>();
}

template <int D, class Real>
void NodeProgram<D, Real>::fill_columns() {
  const auto height = normal_compliance_.rows();
  Eigen::Index c = 0;
  for (const int k : cones_) {
    for (Eigen::Index d = 0; d < D; ++d) {
      auto own = column(d, c);
      own = normal_compliance_.col(D * k + d);
      if (d > 0) own *= Real(friction_[static_cast<std::size_t>(k)]);
      if (!is_reduced()) continue;
      auto equations = own.segment(candidates(), motions_.count());
      equations = equation_basis_.transpose() * equations;
    }
    ++c;
  }
  const Eigen::Index absent = padded<Real>(static_cast<int>(c)) - c;
  for (Eigen::Index d = 0; d < D; ++d)
    for (Eigen::Index more = 0; more < absent; ++more) column(d, c + more).setZero();
  for (Eigen::Index each = 0; each < c; ++each) column(0, each) += right_side_.head(height);
  free_columns_.setZero(padded<Real>(rows()),
                        is_reduced() ? motion_basis_.cols() : motions_.lifting);
  if (is_reduced())
    free_columns_.topRows(first_cut()) = normal_motions_.topRows(first_cut()) * motion_basis_;
  else
    free_columns_.topRows(first_cut()) = normal_motions_.topRows(first_cut());
  for (const int i : empty_rows_) {
    for (Eigen::Index d = 0; d < D; ++d)
      for (Eigen::Index each = 0; each < c; ++each) column(d, each)[i] = Real(0);
    free_columns_.row(i).setZero();
  }
}

// Row i of A states F_i r - slack_i t = A_i x - b_i, and r_ni = x_i0 + t / mu_i. A cut is therefore
//
//   share - displacement (A_i x - b_i) - reaction x_i0 - omega gamma t - v = 0,
//
// omega gamma = displacement slack_i + reaction / mu_i + level, where omega t = 1 - 1'x.
template <int D, class Real>
void NodeProgram<D, Real>::fill_cuts() {
  cut_rows_.clear();
  for (const auto& [i, share, displacement, reaction, level] : cuts_) {
    CutRow<Real> row{.candidate = i, .displacement = displacement, .reaction = reaction};
    Real own = 0;
    for (std::size_t c = 0; c < cones_.size(); ++c) {
      const auto k = static_cast<std::size_t>(cones_[c]);
      if (owners_[k] != i) continue;
      row.cone = static_cast<int>(c);
      own = level_weight<Real>(friction_[k]);
    }
    row.gamma = (displacement * slack_[i] + reaction * own + level) / omega_;
    const auto place = first_cut() + static_cast<Eigen::Index>(cut_rows_.size());
    right_side_[place] = row.gamma - displacement * right_side_[i] - share;
    slack_[place] = Real(1);
    free_columns_.row(place) = Real(-displacement) * free_columns_.row(i);
    cut_rows_.push_back(row);
  }
}

template <int D, class Real>
void NodeProgram<D, Real>::multiply(const ConePoints<D, Real>& x, Vector& sum) const {
  product(matrix(), x.data(), sum.data());
  if (cut_rows_.empty()) return;
  const Real whole = x.col(0).head(static_cast<Eigen::Index>(cones_.size())).sum();
  Eigen::Index place = first_cut();
  for (const auto& [i, cone, displacement, reaction, gamma] : cut_rows_) {
    sum[place] = gamma * whole - displacement * sum[i];
    if (cone >= 0) sum[place] -= reaction * x(cone, 0);
    ++place;
  }
}

template <int D, class Real>
void NodeProgram<D, Real>::multiply_transposed(const Vector& weights,
                                               ConePoints<D, Real>& products) const {
  if (cut_rows_.empty()) return transposed_product(matrix(), weights.data(), products.data());
  forces_ = weights.head(forces_.size());
  forces_.tail(forces_.size() - first_cut()).setZero();
  Real whole = 0;
  Eigen::Index place = first_cut();
  for (const auto& row : cut_rows_) {
    const Real weight = weights[place++];
    forces_[row.candidate] -= row.displacement * weight;
    whole += row.gamma * weight;
  }
  transposed_product(matrix(), forces_.data(), products.data());
  products.col(0).head(static_cast<Eigen::Index>(cones_.size())).array() += whole;
  place = first_cut();
  for (const auto& row : cut_rows_) {
    if (row.cone >= 0) products(row.cone, 0) -= row.reaction * weights[place];
    ++place;
  }
}

template <int D, class Real>
void NodeProgram<D, Real>::reaction(const ConePoints<D, Real>& x, Vector& r) const {
  reaction_at(x, level(x.col(0).head(static_cast<Eigen::Index>(cones_.size())).sum()), r);
}

template <int D, class Real>
void NodeProgram<D, Real>::reaction_change(const ConePoints<D, Real>& x, Vector& r) const {
  reaction_at(x, -x.col(0).head(static_cast<Eigen::Index>(cones_.size())).sum() / omega_, r);
}

template <int D, class Real>
void NodeProgram<D, Real>::reaction_at(const ConePoints<D, Real>& x, const Real& t,
                                       Vector& r) const {
  r.setZero();
  const auto count = static_cast<Eigen::Index>(cones_.size());
  for (Eigen::Index c = 0; c < count; ++c) {
    const auto k = static_cast<std::size_t>(cones_[static_cast<std::size_t>(c)]);
    const auto at = D * static_cast<Eigen::Index>(k);
    r[at] = x(c, 0) + t * level_weight<Real>(friction_[k]);
    for (Eigen::Index d = 1; d < D; ++d) r[at + d] = friction_[k] * x(c, d);
  }
}

template <int D, class Real>
double NodeProgram<D, Real>::friction_level(const Vector& r) const {
  double t = std::numeric_limits<double>::infinity();
  for (const int k : cones_) {
    const auto part = r.template segment<D>(D * k);
    const double mu = friction_[static_cast<std::size_t>(k)];
    const Real own = mu == 0 ? part[0] : Real(mu * part[0] - part.template tail<D - 1>().norm());
    t = std::min(t, numbers::rounded(own));
  }
  return t;
}

template <int D, class Real>
auto NodeProgram<D, Real>::normal_displacements(const Vector& r, const Vector& motion)
    -> const Vector& {
  const auto size = static_cast<int>(r.size());
  gap_.setZero();
  product<Real>(
      {normal_compliance_.data(), static_cast<int>(normal_compliance_.rows()), 1, size, size},
      r.data(), gap_.data());
  if (motion.size() > 0) gap_.head(normal_motions_.rows()) += normal_motions_ * motion;
  return gap_;
}

template <int D, class Real>
auto NodeProgram<D, Real>::discrepancy() -> const Vector& {
  for (const int j : gap_rows_) gap_[j] = Real(0);
  for (const int i : ignored_) gap_[i] = Real(0);
  to_rows(gap_);
  gap_ = -gap_;
  return gap_;
}

template <int D, class Real>
auto NodeProgram<D, Real>::pull(const Vector& y) -> const Vector& {
  const auto columns = static_cast<int>(pull_.size());
  const auto all = static_cast<int>(normal_compliance_.rows());
  forces_.setZero();
  forces_.head(first_cut()) = y.head(first_cut());
  Real shares = 0;
  for (std::size_t cut = 0; cut < cuts_.size(); ++cut) {
    const Real force = y[first_cut() + static_cast<Eigen::Index>(cut)];
    forces_[cuts_[cut].candidate] -= force * cuts_[cut].displacement;
    shares += force * cuts_[cut].share;
  }
  transposed_product<Real>({normal_compliance_.data(), all, 1, columns, columns}, forces_.data(),
                           pull_.data());
  if (cuts_.empty()) return pull_;
  for (const int k : cones_) pull_[D * k] += shares;
  for (std::size_t cut = 0; cut < cuts_.size(); ++cut) {
    const Real force = y[first_cut() + static_cast<Eigen::Index>(cut)];
    for (const int k : cones_)
      if (owners_[static_cast<std::size_t>(k)] == cuts_[cut].candidate)
        pull_[D * k] -= force * cuts_[cut].reaction;
  }
  return pull_;
}

template class NodeProgram<2, double>;
template class NodeProgram<3, double>;
template class NodeProgram<2, long double>;
template class NodeProgram<3, long double>;
template class NodeProgram<2, numbers::Precise>;
template class NodeProgram<3, numbers::Precise>;

}  // namespace kusabi::conic
