// From space to the paper: structures in the plane as they are, those in space in isometric view.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "pictures/svg/canvas.hpp"

namespace kusabi::pictures {

/// A part of the paper, in pixels.
struct Frame {
  Point corner;  ///< top left
  Point size;
};

class View {
 public:
  /// Shows all `points` in the frame, as large as they fit. @param points at least one
  View(int dimension, const std::vector<Eigen::Vector3d>& points, const Frame& frame);

  [[nodiscard]] Point operator()(const Eigen::Vector3d& point) const;
  /// How near to the eye, in lengths of the structure.
  [[nodiscard]] double nearness(const Eigen::Vector3d& point) const;
  /// Pixels for a length across the line of sight.
  [[nodiscard]] double scale() const { return scale_; }

  /// Height over width of what is shown of the points. Between 0 and infinity.
  static double shape(int dimension, const std::vector<Eigen::Vector3d>& points);

 private:
  Eigen::Matrix3d axes_;  // rows: to the right, up, to the eye
  double scale_ = 1;
  Point shift_ = Point::Zero();
};

}  // namespace kusabi::pictures
