#pragma once
// This judges how far ahead one servo goal may send the joints of an arm that has been described.

#include <suture/base/errors.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>

namespace robots {

/// Throws suture::SetupError if a joint that goes at its `rate` for `horizon` seconds, which is as
/// far as one servo goal may send it, could trail by its `followingError`: then a goal that is near
/// enough to be obeyed would put the arm in FAULT.
template <int N>
void requireRoomForServo(const std::array<const char*, std::size_t{N}>& joints, double horizon,
                         const Eigen::Matrix<double, N, 1>& rate,
                         const Eigen::Matrix<double, N, 1>& followingError) {
  for (int i = 0; i < N; ++i) {
    const double ahead = horizon * rate[i];
    if (ahead < followingError[i]) continue;
    const std::string joint = joints[static_cast<std::size_t>(i)];
    throw suture::SetupError(
        "an arm whose joint \"" + joint + "\" moves as far as it can in a \"servo_horizon\" of " +
            std::to_string(horizon) + " s",
        "that is " + std::to_string(ahead) + ", and the arm is in FAULT if the joint trails by " +
            std::to_string(followingError[i]),
        "Lower \"servo_horizon\" or the joint's rate, or raise its following error");
  }
}

}  // namespace robots
