// Written by suturec from bench/loop.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. loop.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "bench/loop.h"
#include "robot_types/pose.suture.h"

namespace bench {

// --- LoopServer: the arguments of its commands ---

struct LoopServerPutArguments {
  robots::PosePrmSlot value;
};

bool store(const robots::PosePrm& value, LoopServerPutArguments& slot);
void shiftStamps(LoopServerPutArguments& slot, suture::Duration shift);

struct LoopServerBounceArguments {
  robots::PosePrmSlot value;
};

bool store(const robots::PosePrm& value, LoopServerBounceArguments& slot);
void shiftStamps(LoopServerBounceArguments& slot, suture::Duration shift);

/// Numbers the commands of LoopServer.
struct LoopServerCommand {
  static constexpr std::uint16_t put = 0;
  static constexpr std::uint16_t bounce = 1;
  static constexpr std::uint16_t value = 2;
};

/// Numbers the events of LoopServer.
struct LoopServerEvent {
  static constexpr std::uint16_t echo = 0;
};

/// Numbers the reads of LoopServer as a row of the state has them.
struct LoopServerColumn {
  static constexpr std::uint16_t value = 0;
};

}  // namespace bench

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<bench::LoopServer>();

/// Calls bench::LoopServer of another component.
template <>
class Required<bench::LoopServer> : public RequiredBase {
  using Contract = bench::LoopServer;
  using Id = bench::LoopServerCommand;
  using EventId = bench::LoopServerEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Server, client, server: takes back what value() answered and measures how long it was away.
  /// Write: up to 16 wait.
  Command<&Contract::put, bench::LoopServerPutArguments> put{*this, Id::put};
  /// Client, server, client: sends the value back as the event echo.
  /// Write: up to 16 wait.
  Command<&Contract::bounce, bench::LoopServerBounceArguments> bounce{*this, Id::bounce};
  /// A pose, stamped when it is evaluated.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::value, robots::PosePrmSlot> value{*this, Id::value};

  /// Subscribes to the events of bench::LoopServer.
  struct Events {
    explicit Events(RequiredBase& required)
        : echo{required, EventId::echo} {}

    /// The value that bounce() took.
    /// At a subscriber up to 16 wait.
    Subscription<robots::PosePrmSlot, robots::PosePrm> echo;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves bench::LoopServer from a component.
template <>
class Provided<bench::LoopServer> : public ProvidedBase {
  using Contract = bench::LoopServer;
  using EventId = bench::LoopServerEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of bench::LoopServer.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : echo{provided, EventId::echo} {}

    /// The value that bounce() took.
    Emitter<robots::PosePrmSlot, robots::PosePrm> echo;
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

  // Reused by every command, so that what they own is allocated once: by reserved().
  struct Scratch {
    robots::PosePrm put_value{};
    robots::PosePrm bounce_value{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
