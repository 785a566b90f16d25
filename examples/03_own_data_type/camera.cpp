#include "03_own_data_type/camera.h"

#include <chrono>

namespace tracking {
namespace {

constexpr std::chrono::milliseconds kPeriod{20};

}  // namespace

Camera::Camera(const CameraParameters& parameters)
    : PeriodicTask({.period = kPeriod}),
      turnPerCycle_(parameters.turn_rate * std::chrono::duration<double>(kPeriod).count()),
      seen_(parameters.first) {}

void Camera::run() { seen_.tip.rotate(Eigen::AngleAxisd(turnPerCycle_, Eigen::Vector3d::UnitZ())); }

}  // namespace tracking
