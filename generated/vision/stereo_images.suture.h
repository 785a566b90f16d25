// Written by suturec from vision/stereo_images.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. stereo_images.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "vision/stereo_images.h"
#include "robot_types/vision.suture.h"

namespace robots {

/// Holds two rectified images of one moment; both stamps are that of the exposure.
struct StereoPairSlot {
  ImageFrameSlot left;
  ImageFrameSlot right;
};

bool store(const StereoPair& value, StereoPairSlot& slot);
void load(const StereoPairSlot& slot, StereoPair& value);
void reserve(const StereoPairSlot*, StereoPair& value);
void shiftStamps(StereoPairSlot& slot, suture::Duration shift);

bool isValid(const StereoPairSlot& slot, suture::FieldPath* path);

/// Numbers the commands of StereoImages.
struct StereoImagesCommand {
  static constexpr std::uint16_t images = 0;
  static constexpr std::uint16_t exposed = 1;
};

/// Numbers the reads of StereoImages as a row of the state has them.
struct StereoImagesColumn {
  static constexpr std::uint16_t images = 0;
  static constexpr std::uint16_t exposed = 1;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::StereoPair& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::StereoPair& value);

template <>
const InterfaceInfo& interfaceInfo<robots::StereoImages>();

/// Calls robots::StereoImages of another component.
template <>
class Required<robots::StereoImages> : public RequiredBase {
  using Contract = robots::StereoImages;
  using Id = robots::StereoImagesCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Returns the last pair; it is not valid while there is nothing to see.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::images, robots::StereoPairSlot> images{*this, Id::images};
  /// Returns the stamp of the last pair, and 0 while there is nothing to see. A client that asks
  /// this first copies megabytes only if they are new.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::exposed, std::int64_t> exposed{*this, Id::exposed};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves robots::StereoImages from a component.
template <>
class Provided<robots::StereoImages> : public ProvidedBase {
  using Contract = robots::StereoImages;

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
