// Written by suturec from registration/registration.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. registration.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "registration/registration.h"

namespace robots {

/// Says where things are: slaves and camera in the frame of the scene, whose z points away from the
/// tissue; masters and display in that of the console. The place of an arm is that of the reference
/// frame in which it gives its poses, which is its base unless set_base_frame() has moved it.
struct SceneFramesSlot {
  std::array<double, 12> left_base;     // Eigen::Isometry3d, m
  std::array<double, 12> right_base;    // Eigen::Isometry3d, m
  std::array<double, 12> camera;        // Eigen::Isometry3d, m
  double tissue;                        // m
  std::array<double, 12> left_master;   // Eigen::Isometry3d, m
  std::array<double, 12> right_master;  // Eigen::Isometry3d, m
  std::array<double, 12> display;       // Eigen::Isometry3d, m
};

bool store(const SceneFrames& value, SceneFramesSlot& slot);
void load(const SceneFramesSlot& slot, SceneFrames& value);

bool isValid(const SceneFramesSlot& slot, suture::FieldPath* path);

// --- Registration: the arguments of its commands ---

struct RegistrationSetCameraArguments {
  std::array<double, 12> camera;  // m
};

bool store(const Eigen::Isometry3d& camera, RegistrationSetCameraArguments& slot);

/// Numbers the commands of Registration.
struct RegistrationCommand {
  static constexpr std::uint16_t frames = 0;
  static constexpr std::uint16_t set_camera = 1;
};

/// Numbers the reads of Registration as a row of the state has them.
struct RegistrationColumn {
  static constexpr std::uint16_t frames = 0;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::SceneFrames& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::SceneFrames& value);

template <>
const InterfaceInfo& interfaceInfo<robots::Registration>();

/// Calls robots::Registration of another component.
template <>
class Required<robots::Registration> : public RequiredBase {
  using Contract = robots::Registration;
  using Id = robots::RegistrationCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Returns the frames as they were registered last; each rotation is one to 1e-6. Ask with
  /// `frames.at(stamp)` for those to which an image or a pose of that stamp belongs.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::frames, robots::SceneFramesSlot> frames{*this, Id::frames};
  /// Says that the left camera has been moved there. It is ignored, with a warning, unless its
  /// rotation is one.
  /// Write: up to 16 wait. `camera` is in m.
  Command<&Contract::set_camera, robots::RegistrationSetCameraArguments> set_camera{
      *this, Id::set_camera};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves robots::Registration from a component.
template <>
class Provided<robots::Registration> : public ProvidedBase {
  using Contract = robots::Registration;

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

  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    Eigen::Isometry3d set_camera_camera{};
  };

  Contract& implementation_;
  Scratch scratch_;
};

}  // namespace suture
