// Written by suturec from robots/arm.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. arm.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "robots/arm.h"
#include "robots/geometry.suture.h"

namespace robots {

/// Every kind of member.
///
/// Two paragraphs.
struct EverythingSlot {
  std::uint8_t on;  // bool
  std::int8_t tiny;
  std::uint64_t count;
  double speed;  // m/s
  float ratio;
  std::int8_t mode;  // Mode
  suture::BoundedText<16> label;
  suture::BoundedList<std::uint8_t, 32> bytes;
  suture::BoundedList<std::uint8_t, 4> flags;
  suture::BoundedList<suture::BoundedText<8>, 3> names;
  suture::BoundedList<std::array<double, 2>, 5> pairs;
  std::array<std::int8_t, 2> modes;
  PoseStampedSlot goal;
  suture::BoundedList<PoseStampedSlot, 2> track;
  std::array<double, 3> point;      // Eigen::Vector3d, m
  std::array<float, 3> plane;       // Eigen::Vector3f
  std::array<double, 9> inertia;    // Eigen::Matrix3d
  std::array<double, 42> jacobian;  // Eigen::Matrix<double, 6, 7>
  std::array<double, 4> attitude;   // Eigen::Quaterniond
  std::int64_t period;              // std::chrono::milliseconds, ns
  std::int64_t when;                // suture::Time, ns
};

bool store(const Everything& value, EverythingSlot& slot);
void load(const EverythingSlot& slot, Everything& value);
void reserve(const EverythingSlot*, Everything& value);
void shiftStamps(EverythingSlot& slot, suture::Duration shift);

bool isKnownMode(std::int8_t slot);
bool isValid(const EverythingSlot& slot, suture::FieldPath* path);

// --- Arm: the arguments of its commands ---

struct ArmServoCpArguments {
  PoseStampedSlot goal;
};

bool store(const PoseStamped& goal, ArmServoCpArguments& slot);
void shiftStamps(ArmServoCpArguments& slot, suture::Duration shift);

struct ArmSetSpeedArguments {
  double speed;  // m/s
};

bool store(const double& speed, ArmSetSpeedArguments& slot);

struct ArmInverseKinematicsArguments {
  PoseStampedSlot x;
  double tolerance;
};

bool store(const PoseStamped& x, const double& tolerance, ArmInverseKinematicsArguments& slot);
void shiftStamps(ArmInverseKinematicsArguments& slot, suture::Duration shift);

struct ArmGraspArguments {
  double width;
  std::int8_t mode;  // Mode
};

bool store(const double& width, const Mode& mode, ArmGraspArguments& slot);

// --- Arm: what its events carry ---

struct ArmMovedPayload {
  PoseStampedSlot value;
  double value2;
  std::int8_t value3;
};

bool store(const PoseStamped& value, const double& value2, const Mode& value3,
           ArmMovedPayload& slot);
void load(const ArmMovedPayload& slot, PoseStamped& value, double& value2, Mode& value3);
void shiftStamps(ArmMovedPayload& slot, suture::Duration shift);

/// Numbers the commands of Arm.
struct ArmCommand {
  static constexpr std::uint16_t enable = 0;
  static constexpr std::uint16_t servo_cp = 1;
  static constexpr std::uint16_t set_speed = 2;
  static constexpr std::uint16_t measured_cp = 3;
  static constexpr std::uint16_t mode = 4;
  static constexpr std::uint16_t everything = 5;
  static constexpr std::uint16_t inverse_kinematics = 6;
  static constexpr std::uint16_t grasp = 7;
  static constexpr std::uint16_t next_token = 8;
  static constexpr std::uint16_t park = 9;
  static constexpr std::uint16_t load = 10;
};

/// Numbers the events of Arm.
struct ArmEvent {
  static constexpr std::uint16_t mode_changed = 0;
  static constexpr std::uint16_t stopped = 1;
  static constexpr std::uint16_t arrived = 2;
  static constexpr std::uint16_t moved = 3;
};

/// Numbers the reads of Arm as a row of the state has them.
struct ArmColumn {
  static constexpr std::uint16_t measured_cp = 0;
  static constexpr std::uint16_t mode = 1;
  static constexpr std::uint16_t everything = 2;
  static constexpr std::uint16_t load = 3;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::Everything& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::Everything& value);

template <>
const InterfaceInfo& interfaceInfo<robots::Arm>();

/// Calls robots::Arm of another component.
template <>
class Required<robots::Arm> : public RequiredBase {
  using Contract = robots::Arm;
  using Id = robots::ArmCommand;
  using EventId = robots::ArmEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Void: up to 4 wait.
  Command<&Contract::enable, NoSlot> enable{*this, Id::enable};
  /// Follow the goal.
  /// Write: a newer one replaces the one that waits. Not executed if it was sent more than 20 ms
  /// ago.
  Command<&Contract::servo_cp, robots::ArmServoCpArguments> servo_cp{*this, Id::servo_cp};
  /// Write: up to 16 wait. `speed` is in m/s.
  Command<&Contract::set_speed, robots::ArmSetSpeedArguments> set_speed{*this, Id::set_speed};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_cp, robots::PoseStampedSlot> measured_cp{*this, Id::measured_cp};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::mode, std::int8_t> mode{*this, Id::mode};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::everything, robots::EverythingSlot> everything{*this, Id::everything};
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  /// `tolerance` is from 0 to 1.
  QualifiedReadCommand<&Contract::inverse_kinematics, robots::ArmInverseKinematicsArguments,
                       robots::EverythingSlot> inverse_kinematics{*this, Id::inverse_kinematics};
  /// Closes the gripper; answers whether it holds something.
  /// Write with return: up to 2 wait. `within()` waits 50 ms for the answer.
  ReturningCommand<&Contract::grasp, robots::ArmGraspArguments, std::uint8_t> grasp{
      *this, Id::grasp};
  /// Void with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::next_token, NoSlot, std::uint32_t> next_token{*this, Id::next_token};
  /// Void: up to 16 wait. Touches atomics only.
  [[deprecated("use enable")]]
  Command<&Contract::park, NoSlot> park{*this, Id::park};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::load, double> load{*this, Id::load};

  /// Subscribes to the events of robots::Arm.
  struct Events {
    explicit Events(RequiredBase& required)
        : mode_changed{required, EventId::mode_changed},
          stopped{required, EventId::stopped},
          arrived{required, EventId::arrived},
          moved{required, EventId::moved} {}

    /// At a subscriber up to 8 wait. Who subscribes later gets the last one.
    Subscription<std::int8_t, robots::Mode> mode_changed;
    /// At a subscriber up to 16 wait.
    Subscription<void> stopped;
    /// At a subscriber up to 16 wait.
    Subscription<robots::PoseStampedSlot, robots::PoseStamped> arrived;
    /// Where, how fast and why.
    /// At a subscriber up to 16 wait. Who subscribes later gets the last one.
    Subscription<robots::ArmMovedPayload, robots::PoseStamped, double, robots::Mode> moved;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
#pragma GCC diagnostic pop

 private:
  Events events_{*this};
};

/// Serves robots::Arm from a component.
template <>
class Provided<robots::Arm> : public ProvidedBase {
  using Contract = robots::Arm;
  using EventId = robots::ArmEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of robots::Arm.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : mode_changed{provided, EventId::mode_changed},
          stopped{provided, EventId::stopped},
          arrived{provided, EventId::arrived},
          moved{provided, EventId::moved} {}

    Emitter<std::int8_t, robots::Mode> mode_changed;
    Emitter<void> stopped;
    Emitter<robots::PoseStampedSlot, robots::PoseStamped> arrived;
    /// Where, how fast and why.
    Emitter<robots::ArmMovedPayload, robots::PoseStamped, double, robots::Mode> moved;
  };
  Events& emit() { return events_; }

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : ProvidedBase(owner, name, info, whole),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  struct Dispatch;  // has a function for each command

  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    robots::PoseStamped servo_cp_goal{};
    double set_speed_speed{};
    robots::PoseStamped inverse_kinematics_x{};
    double inverse_kinematics_tolerance{};
    double grasp_width{};
    robots::Mode grasp_mode{};
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_;
};

}  // namespace suture
