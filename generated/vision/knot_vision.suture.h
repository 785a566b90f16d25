// Written by suturec from vision/knot_vision.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. knot_vision.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "vision/knot_vision.h"

namespace robots {

/// Its points are in the frame of the left camera: x to the right and y downward in the image, z
/// ahead.
struct KnotSightingSlot {
  std::array<double, 3> knot;       // Eigen::Vector3d, m
  std::array<double, 3> left_tip;   // Eigen::Vector3d, m
  std::array<double, 3> right_tip;  // Eigen::Vector3d, m
  std::int64_t stamp;               // suture::Time, ns
  std::uint8_t valid;               // bool
};

bool store(const KnotSighting& value, KnotSightingSlot& slot);
void load(const KnotSightingSlot& slot, KnotSighting& value);
void shiftStamps(KnotSightingSlot& slot, suture::Duration shift);

bool isValid(const KnotSightingSlot& slot, suture::FieldPath* path);

/// Numbers the commands of KnotVision.
struct KnotVisionCommand {
  static constexpr std::uint16_t sighting = 0;
};

/// Numbers the reads of KnotVision as a row of the state has them.
struct KnotVisionColumn {
  static constexpr std::uint16_t sighting = 0;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::KnotSighting& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::KnotSighting& value);

template <>
const InterfaceInfo& interfaceInfo<robots::KnotVision>();

/// Calls robots::KnotVision of another component.
template <>
class Required<robots::KnotVision> : public RequiredBase {
  using Contract = robots::KnotVision;
  using Id = robots::KnotVisionCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Returns what the last pair of images showed.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::sighting, robots::KnotSightingSlot> sighting{*this, Id::sighting};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves robots::KnotVision from a component.
template <>
class Provided<robots::KnotVision> : public ProvidedBase {
  using Contract = robots::KnotVision;

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
