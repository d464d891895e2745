// View: projection to the paper; plane structures as they are, structures in space in isometric
// view.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "pictures/svg/canvas.hpp"

namespace kusabi::pictures {

/// A part of the paper, in pixels.
struct PixelFrame {
  PixelPoint corner;  ///< top left
  PixelPoint size;
};

class View {
 public:
  /// Fits all `points` into the frame. @param points at least one
  View(int dimension, const std::vector<Eigen::Vector3d>& points, const PixelFrame& frame);

  [[nodiscard]] PixelPoint operator()(const Eigen::Vector3d& point) const;
  /// Distance towards the eye, in lengths of the structure.
  [[nodiscard]] double nearness(const Eigen::Vector3d& point) const;
  /// Direction to the eye, unit vector.
  [[nodiscard]] Eigen::Vector3d to_eye() const { return axes_.row(2); }
  /// Pixels per length across the line of sight.
  [[nodiscard]] double scale() const { return scale_; }

  /// Aspect ratio, height over width, of the projected points. Between 0 and infinity.
  static double shape(int dimension, const std::vector<Eigen::Vector3d>& points);

 private:
  Eigen::Matrix3d axes_;  // rows: to the right, up, to the eye
  double scale_ = 1;
  PixelPoint shift_ = PixelPoint::Zero();
};

}  // namespace kusabi::pictures
