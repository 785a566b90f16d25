// Written by suturec from unit/contracts/share.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. share.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "unit/contracts/share.h"

namespace contracts {

// --- Share: the arguments of its commands ---

struct ShareSharesArguments {
  std::uint8_t all;
};

bool store(const bool& all, ShareSharesArguments& slot);

struct ShareTakeArguments {
  double wanted;
};

bool store(const double& wanted, ShareTakeArguments& slot);

/// Numbers the commands of Share.
struct ShareCommand {
  static constexpr std::uint16_t share = 0;
  static constexpr std::uint16_t shares = 1;
  static constexpr std::uint16_t take = 2;
  static constexpr std::uint16_t reach = 3;
};

/// Numbers the reads of Share as a row of the state has them.
struct ShareColumn {
  static constexpr std::uint16_t share = 0;
  static constexpr std::uint16_t reach = 1;
};

}  // namespace contracts

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<contracts::Share>();

/// Calls contracts::Share of another component.
template <>
class Required<contracts::Share> : public RequiredBase {
  using Contract = contracts::Share;
  using Id = contracts::ShareCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Read: answered at once with what the last cycle left. The answer is from 0 to 1.
  ReadCommand<&Contract::share, double> share{*this, Id::share};
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer. The
  /// answer is from 0 to 1.
  QualifiedReadCommand<&Contract::shares, contracts::ShareSharesArguments, std::int32_t> shares{
      *this, Id::shares};
  /// Write with return: up to 16 wait. `within()` waits 1 s for the answer. The answer is from 0 to
  /// 1.
  ReturningCommand<&Contract::take, contracts::ShareTakeArguments, double> take{*this, Id::take};
  /// Read: answered at once with what the last cycle left. The answer is from 0 to inf.
  ReadCommand<&Contract::reach, double> reach{*this, Id::reach};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves contracts::Share from a component.
template <>
class Provided<contracts::Share> : public ProvidedBase {
  using Contract = contracts::Share;

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
    bool shares_all{};
    double take_wanted{};
  };

  Contract& implementation_;
  Scratch scratch_;
};

}  // namespace suture
