#pragma once
// This keeps a vector of joints within bounds without turning it.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace robots {

/// Returns the vector, shortened in its direction until no entry is more than that of `most`.
template <class Joints>
Joints shortened(const Joints& vector, const Joints& most) {
  double share = 1;
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    if (std::abs(vector[i]) > most[i]) share = std::min(share, most[i] / std::abs(vector[i]));
  }
  return share * vector;
}

}  // namespace robots
