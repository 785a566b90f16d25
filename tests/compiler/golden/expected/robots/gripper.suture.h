// Written by suturec from robots/gripper.h. Do not edit.
#pragma once

#include <suture/base/slots.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "robots/gripper.h"
#include "robots/arm.suture.h"
#include "robots/geometry.suture.h"

namespace robots {

// --- Gripper: the arguments of its commands ---

struct GripperOpenArguments {
  double width;  // m
};

inline bool store(const double& width, GripperOpenArguments& slot) {
  using suture::store;
  return store(width, slot.width);
}

struct GripperFitsArguments {
  double width;
};

inline bool store(const double& width, GripperFitsArguments& slot) {
  using suture::store;
  return store(width, slot.width);
}

// --- Gripper: what its events carry ---

struct GripperGrippedPayload {
  double value;
  std::uint8_t value2;
};

inline bool store(const double& value, const bool& value2, GripperGrippedPayload& slot) {
  using suture::store;
  return store(value, slot.value) && store(value2, slot.value2);
}

inline void load(const GripperGrippedPayload& slot, double& value, bool& value2) {
  using suture::load;
  load(slot.value, value);
  load(slot.value2, value2);
}

/// The numbers of Gripper's commands in every table and record.
enum class GripperCommand : std::uint16_t {
  enable,
  servo_cp,
  set_speed,
  measured_cp,
  mode,
  everything,
  inverse_kinematics,
  grasp,
  next_token,
  park,
  load,
  open,
  opening,
  fits,
};

/// The numbers of Gripper's events.
enum class GripperEvent : std::uint16_t {
  mode_changed,
  stopped,
  arrived,
  moved,
  gripped,
};

// --- Names: the arguments of its commands ---

struct NamesQueueArguments {
  std::int32_t name;
};

inline bool store(const std::int32_t& name, NamesQueueArguments& slot) {
  using suture::store;
  return store(name, slot.name);
}

struct NamesNameArguments {
  double range;
  double slot;
};

inline bool store(const double& range, const double& slot, NamesNameArguments& arguments_) {
  using suture::store;
  return store(range, arguments_.range) && store(slot, arguments_.slot);
}

/// The numbers of Names's commands in every table and record.
enum class NamesCommand : std::uint16_t {
  queue,
  name,
  range,
};

/// The numbers of Names's events.
enum class NamesEvent : std::uint16_t {
  latched,
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::Gripper>();

/// What a client of robots::Gripper calls.
template <>
class Required<robots::Gripper> final : public RequiredBase {
  using Contract = robots::Gripper;
  using Id = robots::GripperCommand;
  using EventId = robots::GripperEvent;

 public:
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  Required(Component& owner, std::string_view name)
      : RequiredBase(owner, name, interfaceInfo<Contract>()) {}
#pragma GCC diagnostic pop

  Command<&Contract::enable, NoSlot> enable{*this, static_cast<std::uint16_t>(Id::enable)};
  /// Follow the goal.
  Command<&Contract::servo_cp, robots::ArmServoCpArguments> servo_cp{
      *this, static_cast<std::uint16_t>(Id::servo_cp)};
  Command<&Contract::set_speed, robots::ArmSetSpeedArguments> set_speed{
      *this, static_cast<std::uint16_t>(Id::set_speed)};
  ReadCommand<&Contract::measured_cp, robots::PoseStampedSlot> measured_cp{
      *this, static_cast<std::uint16_t>(Id::measured_cp)};
  ReadCommand<&Contract::mode, std::int8_t> mode{*this, static_cast<std::uint16_t>(Id::mode)};
  ReadCommand<&Contract::everything, robots::EverythingSlot> everything{
      *this, static_cast<std::uint16_t>(Id::everything)};
  QualifiedReadCommand<&Contract::inverse_kinematics, robots::ArmInverseKinematicsArguments,
                       robots::EverythingSlot> inverse_kinematics{
      *this, static_cast<std::uint16_t>(Id::inverse_kinematics)};
  /// Closes the gripper; answers whether it holds something.
  ReturningCommand<&Contract::grasp, robots::ArmGraspArguments, std::uint8_t> grasp{
      *this, static_cast<std::uint16_t>(Id::grasp)};
  ReturningCommand<&Contract::next_token, NoSlot, std::uint32_t> next_token{
      *this, static_cast<std::uint16_t>(Id::next_token)};
  [[deprecated("use enable")]]
  Command<&Contract::park, NoSlot> park{*this, static_cast<std::uint16_t>(Id::park)};
  ReadCommand<&Contract::load, double> load{*this, static_cast<std::uint16_t>(Id::load)};
  Command<&Contract::open, robots::GripperOpenArguments> open{
      *this, static_cast<std::uint16_t>(Id::open)};
  ReadCommand<&Contract::opening, double> opening{*this, static_cast<std::uint16_t>(Id::opening)};
  QualifiedReadCommand<&Contract::fits, robots::GripperFitsArguments, std::uint8_t> fits{
      *this, static_cast<std::uint16_t>(Id::fits)};

  /// The events of robots::Gripper, to subscribe to.
  struct Events {
    explicit Events(RequiredBase& required)
        : mode_changed{required, static_cast<std::uint16_t>(EventId::mode_changed)},
          stopped{required, static_cast<std::uint16_t>(EventId::stopped)},
          arrived{required, static_cast<std::uint16_t>(EventId::arrived)},
          moved{required, static_cast<std::uint16_t>(EventId::moved)},
          gripped{required, static_cast<std::uint16_t>(EventId::gripped)} {}

    Subscription<std::int8_t, robots::Mode> mode_changed;
    Subscription<void> stopped;
    Subscription<robots::PoseStampedSlot, robots::PoseStamped> arrived;
    /// Where, how fast and why.
    Subscription<robots::ArmMovedPayload, robots::PoseStamped, double, robots::Mode> moved;
    Subscription<robots::GripperGrippedPayload, double, bool> gripped;
  };
  Events& on() { return events_; }

 private:
  Events events_{*this};
};

/// What serves robots::Gripper from a component.
template <>
class Provided<robots::Gripper> final : public ProvidedBase {
  using Contract = robots::Gripper;
  using EventId = robots::GripperEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : ProvidedBase(owner, name, interfaceInfo<Contract>(), &implementation),
        implementation_(implementation) {}

  /// The events of robots::Gripper, to emit.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : mode_changed{provided, static_cast<std::uint16_t>(EventId::mode_changed)},
          stopped{provided, static_cast<std::uint16_t>(EventId::stopped)},
          arrived{provided, static_cast<std::uint16_t>(EventId::arrived)},
          moved{provided, static_cast<std::uint16_t>(EventId::moved)},
          gripped{provided, static_cast<std::uint16_t>(EventId::gripped)} {}

    Emitter<std::int8_t, robots::Mode> mode_changed;
    Emitter<void> stopped;
    Emitter<robots::PoseStampedSlot, robots::PoseStamped> arrived;
    /// Where, how fast and why.
    Emitter<robots::ArmMovedPayload, robots::PoseStamped, double, robots::Mode> moved;
    Emitter<robots::GripperGrippedPayload, double, bool> gripped;
  };
  Events& emit() { return events_; }

 private:
  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    robots::PoseStamped servo_cp_goal;
    double set_speed_speed;
    robots::PoseStamped inverse_kinematics_x;
    double inverse_kinematics_tolerance;
    double grasp_width;
    robots::Mode grasp_mode;
    double open_width;
    double fits_width;
  };

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_{};
};

template <>
const InterfaceInfo& interfaceInfo<robots::Names>();

/// What a client of robots::Names calls.
template <>
class Required<robots::Names> final : public RequiredBase {
  using Contract = robots::Names;
  using Id = robots::NamesCommand;
  using EventId = robots::NamesEvent;

 public:
  Required(Component& owner, std::string_view nameGiven)
      : RequiredBase(owner, nameGiven, interfaceInfo<Contract>()) {}

  Command<&Contract::queue, robots::NamesQueueArguments> queue{
      *this, static_cast<std::uint16_t>(Id::queue)};
  ReturningCommand<&Contract::name, robots::NamesNameArguments, std::uint8_t> name{
      *this, static_cast<std::uint16_t>(Id::name)};
  ReadCommand<&Contract::range, double> range{*this, static_cast<std::uint16_t>(Id::range)};

  /// The events of robots::Names, to subscribe to.
  struct Events {
    explicit Events(RequiredBase& required)
        : latched{required, static_cast<std::uint16_t>(EventId::latched)} {}

    Subscription<double, double> latched;
  };
  Events& on() { return events_; }

 private:
  Events events_{*this};
};

/// What serves robots::Names from a component.
template <>
class Provided<robots::Names> final : public ProvidedBase {
  using Contract = robots::Names;
  using EventId = robots::NamesEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : ProvidedBase(owner, name, interfaceInfo<Contract>(), &implementation),
        implementation_(implementation) {}

  /// The events of robots::Names, to emit.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : latched{provided, static_cast<std::uint16_t>(EventId::latched)} {}

    Emitter<double, double> latched;
  };
  Events& emit() { return events_; }

 private:
  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    std::int32_t queue_name;
    double name_range;
    double name_slot;
  };

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_{};
};

}  // namespace suture
