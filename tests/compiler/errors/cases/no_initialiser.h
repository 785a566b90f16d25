#pragma once
#include <demo/bare.h>
#include <suture/annotate.h>

#include <Eigen/Geometry>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>
namespace lib {
struct Point {
  double x, y;
};
struct Wrench : Point {
  Point moment;
  std::string label;
};
struct Settled {
  Settled();
  double x;
};
struct Given {
  double x = 0;
  Eigen::Vector3d axis;
};
}  // namespace lib
namespace demo {
enum class SUTURE_TYPE() Mode { Servo = 1, Off = 0 };
enum class SUTURE_TYPE() Step { First = 1, Second };
SUTURE_EXTERNAL_TYPE(lib::Point);
SUTURE_EXTERNAL_TYPE(lib::Wrench, all(), member(label, capacity(3)));
SUTURE_EXTERNAL_TYPE(lib::Settled);
SUTURE_EXTERNAL_TYPE(lib::Given);
struct SUTURE_TYPE() Grip {
  double width;
  bool closed;
  std::uint8_t code, other;
  std::byte raw;
  Mode mode;
  Step step;
  double force[2];
  std::array<std::array<int, 2>, 3> counts;
  std::chrono::milliseconds pause;
  Eigen::Vector3d axis;
  Eigen::Quaterniond turn;
  Eigen::Isometry3d pose;
  Eigen::Vector3d braces{};
  std::array<Eigen::Vector2d, 2> corners{};
  SUTURE_FIELD(range(-1, 1)) float share;
  double aligned [[maybe_unused]];
};
struct SUTURE_TYPE() OfOthers {
  lib::Point point;
  lib::Wrench wrench;
  std::array<lib::Point, 2> both;
};
#define PLAIN double plain
struct SUTURE_TYPE() InMacro {
  PLAIN;
};
struct SUTURE_TYPE() InList {
  InList() : listed(1), zero(), axis() {}
  double listed, zero, forgotten;
  Eigen::Vector3d axis;
};
struct SUTURE_TYPE() Defaulted {
  Defaulted() = default;
  explicit Defaulted(double given) : number(given) {}
  double number;
};
template <class T>
struct SUTURE_TYPE() Box {
  T value;
  Mode mode;
};
using IntBox = Box<int>;
using RealBox = Box<double>;
using ModeBox = Box<Mode>;
using BareInt = BareBox<int>;
struct SUTURE_TYPE() Quiet {
  double number = 1, zero{};
  Mode mode{};
  double force[2] = {};
  std::array<double, 2> both{};
  std::chrono::seconds pause{};
  std::chrono::steady_clock::time_point stamp;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  std::optional<double> perhaps;
  SUTURE_FIELD(capacity(3)) std::string text;
  SUTURE_FIELD(capacity(3)) std::vector<double> list;
  SUTURE_FIELD(skip()) double hidden;
  lib::Point point{};
  lib::Settled settled;
  lib::Given given;
  std::optional<lib::Point> none;
  Bare bare;
  BareInt box;
};
}  // namespace demo
