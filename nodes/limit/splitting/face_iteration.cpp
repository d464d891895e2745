// Steps on a face.
#include "nodes/limit/splitting/face_iteration.hpp"

#include <cmath>
#include <utility>

#include "nodes/limit/splitting/block_sweep.hpp"
#include "nodes/limit/splitting/row_projection.hpp"

namespace kusabi::limit::splitting {
namespace {

constexpr double relaxation = 1.2;

/// Steps of a cycle, after which the point is extrapolated.
constexpr int cycle = 5;

/// Shift of the diagonal, since members without elongation may not support all displacements.
constexpr double shift = 1e-11;

using SparseMatrix = Eigen::SparseMatrix<double>;

}  // namespace

FaceIteration::FaceIteration(const AffineProgram& program, AffineProjection& projection,
                             const Sharing& sharing, Face face, AffineIteration& start)
    : program_(program),
      projection_(projection),
      sharing_(sharing),
      face_(std::move(face)),
      rows_(program, face_, sharing),
      point_{{program.rows(), static_cast<int>(program.columns.size()), sharing}, {}},
      y_(point_.columns) {
  still_load_ = face_.critical;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < program.rows(); ++i) {
    const int stretch = i < program.members() ? face_.stretches[static_cast<std::size_t>(i)] : 0;
    for (SparseMatrix::InnerIterator entry(program.equilibrium, i); entry; ++entry) {
      if (stretch == 0) {
        entries.emplace_back(static_cast<int>(entry.row()), i, entry.value());
      } else {
        still_load_(entry.row()) -= entry.value() * stretch * program.capacity(i);
      }
    }
  }
  still_.resize(program.displacements(), program.rows());
  still_.setFromTriplets(entries.begin(), entries.end());
  SparseMatrix identity(program.displacements(), program.displacements());
  identity.setIdentity();
  const SparseMatrix gram = still_ * still_.transpose();
  factor_.compute(gram + shift * identity);
  start_from(start);
  acceleration_.emplace(point_, sharing);
}

void FaceIteration::start_from(AffineIteration& start) {
  const auto rows = static_cast<std::size_t>(program_.rows());
  const auto& y = start.affine_point();
  auto& z = point_.columns;
  std::vector<double> sums(rows * static_cast<std::size_t>(z.groups()), 0.0);
  for (int group = z.first_group(); group < z.end_group(); ++group) {
    auto* const sum = sums.data() + static_cast<std::size_t>(group) * rows;
    const int end = std::min(z.columns(), (group + 1) * group_columns);
    for (int column = group * group_columns; column < end; ++column) {
      for (int i = 0; i < program_.rows(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (column == 0) {
          sum[at] += y.at(i, 0);
          continue;
        }
        const double w =
            face_.signs[static_cast<std::size_t>(column - 1)] * start.row_point(i, column);
        z.set(i, column, w);
        sum[at] += w;
      }
    }
  }
  const auto total = added(sums, rows, sharing_);
  point_.rest = Eigen::Map<const Eigen::VectorXd>(total.data(), program_.rows());
  point_.rest(program_.members()) = face_.factor;
}

KUSABI_INLINE Segment FaceIteration::reflected(int first_column, int row, const Segment& z) const {
  const Segment cut = rows_.cut_off(row, z, rows_.works(first_column));
  Segment w;
  for (int h = 0; h < block_lanes; ++h) w.part[h] = z.part[h] - 2 * cut.part[h];
  return w;
}

// The same step for the state, on every rank.
void FaceIteration::move_state(double& square) {
  auto& state = point_.rest;
  const auto& nearest = rows_.state();
  Eigen::VectorXd y = 2 * nearest - state;
  const auto is_still = [this](int i) {
    return i == program_.members() || face_.stretches[static_cast<std::size_t>(i)] == 0;
  };
  for (int i = 0; i < program_.rows(); ++i) {
    if (!is_still(i)) y(i) = 0;
  }
  for (int time = 0; time < 2; ++time) {
    const Eigen::VectorXd lacking = still_ * y - still_load_;
    y -= still_.transpose() * factor_.solve(lacking);
  }
  for (int i = 0; i < program_.rows(); ++i) {
    if (!is_still(i)) continue;
    const double apart = y(i) - nearest(i);
    state(i) += relaxation * apart;
    square += apart * apart;
  }
}

// An extrapolated point is kept if its residual is not larger; plain steps never increase it.
void FaceIteration::step() {
  const bool begins = steps_ > 0 && steps_ % cycle == 0;
  const double before = residual_;
  if (begins) acceleration_->advance(point_);
  plain_step();
  if (begins && acceleration_->extrapolates() && residual_ > before) {
    acceleration_->reject(point_);
    --steps_;
    plain_step();
  }
}

KUSABI_ALSO_FOR_AVX2 void FaceIteration::plain_step() {
  rows_.find(point_.columns, point_.rest);
  double square = 0;
  move_state(square);
  std::vector<double> squares(static_cast<std::size_t>(point_.columns.groups()), 0.0);
  Segment sum{};
  const auto& metric = projection_.metric();
  sweep(
      projection_, face_.columns, point_.columns,
      [this](const BlockPlace& place, int row, const Segment& z) {
        return reflected(place.first_column(), row, z);
      },
      [&](const BlockPlace& place, int row, const Segment& w, const Segment& y) {
        Segment& z = point_.columns.block(place.group, place.number)[row];
        const double weight = 1 / metric(row);
        for (int h = 0; h < block_lanes; ++h) {
          const Lanes apart = y.part[h] - 0.5 * (z.part[h] + w.part[h]);
          sum.part[h] += weight * apart * apart;
          z.part[h] += relaxation * apart;
        }
        if (row < program_.members()) return;
        squares[static_cast<std::size_t>(place.group)] += sum_of(sum);
        sum = {};
      });
  residual_ = std::sqrt(square + added(squares, 1, sharing_).front());
  ++steps_;
}

const ColumnBlocks& FaceIteration::affine_point() {
  sweep(
      projection_, face_.columns, point_.columns,
      [this](const BlockPlace& place, int row, const Segment& z) {
        return reflected(place.first_column(), row, z);
      },
      [&](const BlockPlace& place, int row, const Segment& /*w*/, const Segment& y) {
        Segment& target = y_.block(place.group, place.number)[row];
        for (int h = 0; h < block_lanes; ++h) {
          Lanes signs{};
          for (int l = 0; l < lanes; ++l) {
            const int column = place.first_column() + h * lanes + l;
            const bool is_load = column > 0 && column < point_.columns.columns();
            signs[l] = is_load ? face_.signs[static_cast<std::size_t>(column - 1)] : 0;
          }
          target.part[h] = signs * y.part[h];
        }
      });
  return y_;
}

}  // namespace kusabi::limit::splitting
