#include "experiment/room/camera.h"

#include "strand/strand.h"

namespace experiment {

using Eigen::Vector3d;
using robots::Strand;

Camera::Camera(const CameraModel& model)
    : PeriodicTask({.period = model.period}),
      model_(model),
      random_(model.seed),
      lost_(model.dropout) {}

void Camera::run() {
  if (lost_(random_)) return;  // the last sighting stays the last
  const auto strand = strand_.strand.delayed(model_.latency);
  const auto frames = registration_.frames();
  sighting_.valid = strand && strand->valid && frames;
  if (!sighting_.valid) return;
  const Eigen::Isometry3d toCamera = frames->camera.inverse();
  sighting_.knot = seen(toCamera * strand->nodes.col(Strand::kKnot));
  sighting_.left_tip = seen(toCamera * strand->nodes.col(0));
  sighting_.right_tip = seen(toCamera * strand->nodes.col(Strand::kNodes - 1));
  sighting_.stamp = strand->stamp;
}

/// Returns the point as it is seen, in the frame of the left camera.
Vector3d Camera::seen(const Vector3d& point) {
  const double depth = cameras_.depthOf(point.z(), model_.disparity) * normal_(random_);
  const double across = point.z() / cameras_.focal * model_.disparity;
  const Vector3d aside{across * normal_(random_), across * normal_(random_), 0};
  return point + depth / point.z() * point + aside;
}

}  // namespace experiment
