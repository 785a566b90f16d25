// Written by suturec from vision/tracked_object.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. tracked_object.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "vision/tracked_object.h"
#include "robot_types/cartesian.suture.h"
#include "robot_types/pose.suture.h"

namespace robots {

/// Numbers the commands of TrackedObject.
struct TrackedObjectCommand {
  static constexpr std::uint16_t measured_cp = 0;
  static constexpr std::uint16_t measured_cv = 1;
};

/// Numbers the reads of TrackedObject as a row of the state has them.
struct TrackedObjectColumn {
  static constexpr std::uint16_t measured_cp = 0;
  static constexpr std::uint16_t measured_cv = 1;
};

}  // namespace robots

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<robots::TrackedObject>();

/// Calls robots::TrackedObject of another component.
template <>
class Required<robots::TrackedObject> : public RequiredBase {
  using Contract = robots::TrackedObject;
  using Id = robots::TrackedObjectCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Says where it is at the stamp, which is that of the tracker's cycle: images are old when they
  /// come, and this is what they showed, extrapolated by its velocity. It is not valid unless the
  /// last pair of images showed it, and not long ago.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_cp, robots::PoseStampedSlot> measured_cp{*this, Id::measured_cp};
  /// Says how fast it moves; it is valid when the pose is.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::measured_cv, robots::TwistSlot> measured_cv{*this, Id::measured_cv};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves robots::TrackedObject from a component.
template <>
class Provided<robots::TrackedObject> : public ProvidedBase {
  using Contract = robots::TrackedObject;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : ProvidedBase(owner, name, info, whole),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  struct Dispatch;  // has a function for each command

  Contract& implementation_;
};

}  // namespace suture
