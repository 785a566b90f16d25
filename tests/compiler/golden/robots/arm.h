#pragma once
// One of everything that suturec reads: the hand-made model in tests/unit/emit says the same.

#include <suture/annotate.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "robots/geometry.h"

namespace robots {

/// What the arm does.
enum class SUTURE_TYPE() Mode : std::int8_t {
  Disabled = -1,
  HoldStill = 4,  ///< Brakes off, set-point frozen.
  Servo = 2
};

/// Every kind of member.
///
/// Two paragraphs.
struct SUTURE_TYPE() Everything {
  bool on = false;
  std::int8_t tiny = 0;
  std::uint64_t count = 0;
  /// Along the path.
  SUTURE_FIELD(unit("m/s"), range(-0.5, 2)) double speed = 0.25;
  float ratio = 0;
  Mode mode = Mode::Servo;
  SUTURE_FIELD(capacity(16)) std::string label;
  SUTURE_FIELD(capacity(32)) std::vector<std::uint8_t> bytes;
  SUTURE_FIELD(capacity(4)) std::vector<bool> flags;
  SUTURE_FIELD(capacity(3, 8)) std::vector<std::string> names;
  SUTURE_FIELD(capacity(5)) std::vector<std::array<double, 2>> pairs;
  std::array<Mode, 2> modes{};
  PoseStamped goal;
  SUTURE_FIELD(capacity(2)) std::vector<PoseStamped> track;
  SUTURE_FIELD(unit("m")) Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3f plane = Eigen::Vector3f::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 6, 7> jacobian = Eigen::Matrix<double, 6, 7>::Zero();
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  std::chrono::milliseconds period{0};
  std::chrono::steady_clock::time_point when;
};

/// A robot arm.
class SUTURE_INTERFACE() Arm {
 public:
  virtual ~Arm() = default;
  SUTURE_COMMAND(queue(4)) virtual void enable() = 0;
  /// Follow the goal.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_cp(const PoseStamped& goal) = 0;
  SUTURE_COMMAND() virtual void set_speed(SUTURE_FIELD(unit("m/s")) double speed) = 0;
  SUTURE_COMMAND() virtual PoseStamped measured_cp() const = 0;
  SUTURE_COMMAND() virtual Mode mode() const = 0;
  SUTURE_COMMAND() virtual const Everything& everything() const = 0;
  SUTURE_COMMAND()
  virtual const Everything& inverse_kinematics(const PoseStamped& x,
                                               SUTURE_FIELD(range(0,
                                                                  1)) double tolerance) const = 0;
  /// Closes the gripper; answers whether it holds something.
  SUTURE_COMMAND(deadline(50ms), queue(2)) virtual bool grasp(double width, Mode mode) = 0;
  SUTURE_COMMAND(since(1)) virtual std::uint32_t next_token() = 0;
  SUTURE_COMMAND(optional(), deprecated("use enable"), direct()) virtual void park() {}
  SUTURE_COMMAND(optional()) virtual double load() const { return 0; }
  SUTURE_EVENT(latched(), queue(8), name("mode_changed")) suture::EventOf<Mode> mode_changed_event;
  SUTURE_EVENT(name("stopped")) suture::EventOf<> stopped_event;
  SUTURE_EVENT(name("arrived")) suture::EventOf<PoseStamped> arrived_event;
  /// Where, how fast and why.
  SUTURE_EVENT(latched(), name("moved"))
  suture::EventOf<PoseStamped, double, Mode> moved_event;
};

}  // namespace robots
