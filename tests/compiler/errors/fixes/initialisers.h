#pragma once
#include <suture/annotate.h>

#include <Eigen/Geometry>
#include <array>
#include <chrono>
#include <cstdint>
namespace demo {
enum class SUTURE_TYPE() Mode { Servo = 1, Off = 0 };
enum class SUTURE_TYPE() Step { First = 1, Second };
struct SUTURE_TYPE() Grip {
  enum SUTURE_TYPE() Side { Left, Right };
  double width;
  bool closed;
  std::uint8_t code, other;
  demo::Mode mode;
  Step step;
  Side side;
  double force[2];  ///< on each finger
  std::array<int, 3> counts;
  std::chrono::milliseconds pause;
  Eigen::Matrix<double, 6, 1> wrench;
  Eigen::Quaterniond turn;
  Eigen::Isometry3d pose;
};
template <class T>
struct SUTURE_TYPE() Box {
  T value;
};
using IntBox = Box<int>;
using ModeBox = Box<Mode>;
}  // namespace demo
