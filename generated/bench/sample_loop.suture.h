// Written by suturec from bench/sample_loop.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. sample_loop.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "bench/sample_loop.h"
#include "robot_types/pose.suture.h"

namespace bench {

// --- SampleServer: the arguments of its commands ---

struct SampleServerPutArguments {
  robots::PoseSampleSlot value;
};

bool store(const robots::PoseSample& value, SampleServerPutArguments& slot);
void shiftStamps(SampleServerPutArguments& slot, suture::Duration shift);

struct SampleServerBounceArguments {
  robots::PoseSampleSlot value;
};

bool store(const robots::PoseSample& value, SampleServerBounceArguments& slot);
void shiftStamps(SampleServerBounceArguments& slot, suture::Duration shift);

/// Numbers the commands of SampleServer.
struct SampleServerCommand {
  static constexpr std::uint16_t put = 0;
  static constexpr std::uint16_t bounce = 1;
  static constexpr std::uint16_t value = 2;
};

/// Numbers the events of SampleServer.
struct SampleServerEvent {
  static constexpr std::uint16_t echo = 0;
};

/// Numbers the reads of SampleServer as a row of the state has them.
struct SampleServerColumn {
  static constexpr std::uint16_t value = 0;
};

}  // namespace bench

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<bench::SampleServer>();

/// Calls bench::SampleServer of another component.
template <>
class Required<bench::SampleServer> : public RequiredBase {
  using Contract = bench::SampleServer;
  using Id = bench::SampleServerCommand;
  using EventId = bench::SampleServerEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Counted by the provider.
  /// Write: up to 4096 wait.
  Command<&Contract::put, bench::SampleServerPutArguments> put{*this, Id::put};
  /// Client, server, client: sends the value back as the event echo.
  /// Write: up to 16 wait.
  Command<&Contract::bounce, bench::SampleServerBounceArguments> bounce{*this, Id::bounce};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::value, robots::PoseSampleSlot> value{*this, Id::value};

  /// Subscribes to the events of bench::SampleServer.
  struct Events {
    explicit Events(RequiredBase& required)
        : echo{required, EventId::echo} {}

    /// The value that bounce() took.
    /// At a subscriber up to 16 wait.
    Subscription<robots::PoseSampleSlot, robots::PoseSample> echo;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves bench::SampleServer from a component.
template <>
class Provided<bench::SampleServer> : public ProvidedBase {
  using Contract = bench::SampleServer;
  using EventId = bench::SampleServerEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of bench::SampleServer.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : echo{provided, EventId::echo} {}

    /// The value that bounce() took.
    Emitter<robots::PoseSampleSlot, robots::PoseSample> echo;
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
    robots::PoseSample put_value{};
    robots::PoseSample bounce_value{};
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_;
};

}  // namespace suture
