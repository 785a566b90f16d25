#pragma once

#include <Eigen/Core>

#include "strand/strand.h"

namespace robots::test {

/// Returns a strand whose sides hang straight from the tips to the knot; m, in the frame of the
/// left camera.
inline Strand::Nodes hanging(const Eigen::Vector3d& left, const Eigen::Vector3d& knot,
                             const Eigen::Vector3d& right) {
  Strand::Nodes strand;
  for (int i = 0; i < Strand::kNodes; ++i) {
    const double t = static_cast<double>(i) / Strand::kKnot;
    strand.col(i) = t <= 1 ? left + t * (knot - left) : knot + (t - 1) * (right - knot);
  }
  return strand;
}

}  // namespace robots::test
