#pragma once
// The examples of docs/diagnostics name these and do not declare them. An example that declares one
// of these names hides it.
#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/component.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace example {

struct SUTURE_TYPE() Pose {
  double x = 0, y = 0, z = 0;
};
struct SUTURE_TYPE() PoseStamped {
  Pose pose;
  suture::Time stamp;
};
struct SUTURE_TYPE() Goal {
  Pose pose;
};
struct SUTURE_TYPE() JointGoal {
  SUTURE_FIELD(capacity(8)) std::vector<double> position;
};
struct SUTURE_TYPE() JointState {
  SUTURE_FIELD(capacity(8)) std::vector<double> position, velocity, effort;
};
struct SUTURE_TYPE() Message {
  SUTURE_FIELD(capacity(80)) std::string text;
};
struct SUTURE_TYPE() PsmParameters {
  double rate = 1000;
};
struct SUTURE_TYPE() Entry {
  std::string text;
};
struct SUTURE_TYPE() Tree {
  SUTURE_FIELD(capacity(4)) std::vector<Tree> branches;
};
struct SUTURE_TYPE() State {
  bool on = false;
};
struct SUTURE_TYPE() Move {
  double length = 0, speed = 0;
};
struct SUTURE_TYPE() Circle {
  double radius = 0;
};
struct SUTURE_TYPE() Square {
  double side = 0;
};

class SUTURE_INTERFACE() Arm {
 public:
  virtual ~Arm() = default;
  SUTURE_COMMAND() virtual void enable() = 0;
};
class SUTURE_INTERFACE() Archive {
 public:
  virtual ~Archive() = default;
  SUTURE_COMMAND() virtual const Entry& newest() const = 0;
};
class SUTURE_INTERFACE() Forest {
 public:
  virtual ~Forest() = default;
  SUTURE_COMMAND() virtual void plant(const Tree& tree) = 0;
};
class SUTURE_INTERFACE() Device {
 public:
  virtual ~Device() = default;
  SUTURE_COMMAND() virtual void hold() = 0;
};
class SUTURE_INTERFACE() Motion {
 public:
  virtual ~Motion() = default;
  SUTURE_COMMAND() virtual void stop() = 0;
};

template <class T>
struct SUTURE_TYPE() Stamped {
  T value{};
  suture::Time stamp;
};

/// A component: no contract.
class Psm : public suture::EventTask {};

struct Shape {
  virtual ~Shape() = default;
};
struct MyClock {
  using duration = std::chrono::nanoseconds;
};
double fromFile();
const char* nameFromFile();

}  // namespace example

namespace lib {
template <class T>
struct Box {
  T value{};
};
}  // namespace lib

namespace demo {
using namespace example;
struct Angle {
  explicit Angle(double degrees = 0) : degrees_(degrees) {}

 private:
  double degrees_;
};
}  // namespace demo
