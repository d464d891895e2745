// Signs of elongations and of work.
#include "nodes/limit/splitting/face.hpp"

#include <cmath>
#include <utility>

namespace kusabi::limit::splitting {
namespace {

/// Members with elongations below this share of the largest, and loads whose work relative to their
/// size is below this share of the largest, count as zero.
constexpr double no_stretch = 1e-8;
constexpr double no_work = 1e-9;

}  // namespace

Face face_of(const AffineProgram& program, double factor, const Eigen::VectorXd& motion,
             std::vector<int> signs) {
  Face face;
  face.factor = factor;
  const int members = program.members();
  const Eigen::VectorXd stretch = program.equilibrium.leftCols(members).transpose() * motion;
  const double max_stretch = stretch.cwiseAbs().maxCoeff();
  for (int i = 0; i < members; ++i) {
    const bool yields = std::abs(stretch(i)) > no_stretch * max_stretch;
    face.stretches.push_back(!yields ? 0 : stretch(i) > 0 ? 1 : -1);
  }
  const double max_motion = motion.cwiseAbs().maxCoeff();
  face.critical = program.dead;
  face.columns.emplace_back();
  for (std::size_t j = 0; j < program.loads.size(); ++j) {
    SparseLoad load = program.loads[j];
    double work = 0;
    double size = 0;
    for (auto& [degree, value] : load) {
      value *= signs[j];
      work += value * motion(degree);
      size += std::abs(value);
      face.critical(degree) += value;
    }
    face.works.push_back(std::abs(work) > no_work * size * max_motion);
    face.columns.push_back(std::move(load));
  }
  face.signs = std::move(signs);
  return face;
}

}  // namespace kusabi::limit::splitting
