// Written by suturec from strand/strand_view.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. strand_view.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "strand/strand_view.h"

namespace robots {

struct StrandStateSlot {
  std::array<double, 183> nodes;  // Eigen::Matrix<double, 3, 61>, m
  double left_length;             // m
  double left_tension;            // N
  double right_tension;           // N
  std::int64_t stamp;             // suture::Time, ns
  std::uint8_t valid;             // bool
};

bool store(const StrandState& value, StrandStateSlot& slot);
void load(const StrandStateSlot& slot, StrandState& value);
void shiftStamps(StrandStateSlot& slot, suture::Duration shift);

bool isValid(const StrandStateSlot& slot, suture::FieldPath* path);

/// Numbers the commands of StrandView.
struct StrandViewCommand {
  static constexpr std::uint16_t strand = 0;
};

/// Numbers the reads of StrandView as a row of the state has them.
struct StrandViewColumn {
  static constexpr std::uint16_t strand = 0;
};

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::StrandState& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::StrandState& value);

template <>
const InterfaceInfo& interfaceInfo<robots::StrandView>();

/// Calls robots::StrandView of another component.
template <>
class Required<robots::StrandView> : public RequiredBase {
  using Contract = robots::StrandView;
  using Id = robots::StrandViewCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Returns the strand as it is at the end of the simulation's last cycle, which is its stamp.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::strand, robots::StrandStateSlot> strand{*this, Id::strand};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves robots::StrandView from a component.
template <>
class Provided<robots::StrandView> : public ProvidedBase {
  using Contract = robots::StrandView;

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
