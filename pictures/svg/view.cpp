// Isometric view: the eye is at (1, -1, 1): x goes down to the right, y up to the right, z up.
#include "pictures/svg/view.hpp"

#include <algorithm>
#include <cmath>

namespace kusabi::pictures {
namespace {

Eigen::Matrix3d axes_of(int dimension) {
  if (dimension == 2) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d axes;
  axes.row(0) = Eigen::RowVector3d(1, 1, 0) / std::sqrt(2.0);
  axes.row(1) = Eigen::RowVector3d(-1, 1, 2) / std::sqrt(6.0);
  axes.row(2) = Eigen::RowVector3d(1, -1, 1) / std::sqrt(3.0);
  return axes;
}

// Bounding box: minimum and maximum to the right and up.
Eigen::Matrix2d bounds(const Eigen::Matrix3d& axes, const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix2d box;
  box.col(0) = box.col(1) = (axes * points.front()).head<2>();
  for (const auto& point : points) {
    const Eigen::Vector2d seen = (axes * point).head<2>();
    box.col(0) = box.col(0).cwiseMin(seen);
    box.col(1) = box.col(1).cwiseMax(seen);
  }
  return box;
}

}  // namespace

View::View(int dimension, const std::vector<Eigen::Vector3d>& points, const PixelFrame& frame)
    : axes_(axes_of(dimension)) {
  const auto box = bounds(axes_, points);
  const Eigen::Vector2d size = box.col(1) - box.col(0);
  const double largest = size.maxCoeff();
  if (largest > 0) {
    scale_ = frame.size.maxCoeff() / largest;
    for (int i = 0; i < 2; ++i) {
      if (size(i) > 0) scale_ = std::min(scale_, frame.size(i) / size(i));
    }
  }
  const Eigen::Vector2d middle = box.rowwise().mean();
  shift_ = frame.corner + frame.size / 2 - scale_ * PixelPoint(middle.x(), -middle.y());
}

PixelPoint View::operator()(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d seen = axes_ * point;
  return shift_ + scale_ * PixelPoint(seen.x(), -seen.y());
}

double View::nearness(const Eigen::Vector3d& point) const {
  return axes_.row(2).dot(point);
}

double View::shape(int dimension, const std::vector<Eigen::Vector3d>& points) {
  const auto box = bounds(axes_of(dimension), points);
  const Eigen::Vector2d size = box.col(1) - box.col(0);
  return size.x() > 0 ? size.y() / size.x() : 1;
}

}  // namespace kusabi::pictures
