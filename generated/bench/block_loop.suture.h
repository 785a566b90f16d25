// Written by suturec from bench/block_loop.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. block_loop.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "bench/block_loop.h"

namespace bench {

/// As large as a pose.
struct SmallBlockSlot {
  suture::BoundedList<std::uint8_t, 120> bytes;
};

bool store(const SmallBlock& value, SmallBlockSlot& slot);
void load(const SmallBlockSlot& slot, SmallBlock& value);
void reserve(const SmallBlockSlot*, SmallBlock& value);

/// As large as an image at most.
struct LargeBlockSlot {
  suture::BoundedList<std::uint8_t, 1048576> bytes;
};

bool store(const LargeBlock& value, LargeBlockSlot& slot);
void load(const LargeBlockSlot& slot, LargeBlock& value);
void reserve(const LargeBlockSlot*, LargeBlock& value);

bool isValid(const SmallBlockSlot& slot, suture::FieldPath* path);
bool isValid(const LargeBlockSlot& slot, suture::FieldPath* path);

// --- SmallBlocks: the arguments of its commands ---

struct SmallBlocksBounceArguments {
  SmallBlockSlot block;
};

bool store(const SmallBlock& block, SmallBlocksBounceArguments& slot);

/// Numbers the commands of SmallBlocks.
struct SmallBlocksCommand {
  static constexpr std::uint16_t bounce = 0;
};

/// Numbers the events of SmallBlocks.
struct SmallBlocksEvent {
  static constexpr std::uint16_t echo = 0;
};

// --- LargeBlocks: the arguments of its commands ---

struct LargeBlocksBounceArguments {
  LargeBlockSlot block;
};

bool store(const LargeBlock& block, LargeBlocksBounceArguments& slot);

/// Numbers the commands of LargeBlocks.
struct LargeBlocksCommand {
  static constexpr std::uint16_t bounce = 0;
};

/// Numbers the events of LargeBlocks.
struct LargeBlocksEvent {
  static constexpr std::uint16_t echo = 0;
};

}  // namespace bench

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const bench::SmallBlock& value);
template <>
Result<> decode(std::span<const std::byte> bytes, bench::SmallBlock& value);

template <>
Result<std::vector<std::byte>> encode(const bench::LargeBlock& value);
template <>
Result<> decode(std::span<const std::byte> bytes, bench::LargeBlock& value);

template <>
const InterfaceInfo& interfaceInfo<bench::SmallBlocks>();

/// Calls bench::SmallBlocks of another component.
template <>
class Required<bench::SmallBlocks> : public RequiredBase {
  using Contract = bench::SmallBlocks;
  using Id = bench::SmallBlocksCommand;
  using EventId = bench::SmallBlocksEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Client, server, client: sends the block back as the event echo.
  /// Write: up to 2 wait.
  Command<&Contract::bounce, bench::SmallBlocksBounceArguments> bounce{*this, Id::bounce};

  /// Subscribes to the events of bench::SmallBlocks.
  struct Events {
    explicit Events(RequiredBase& required)
        : echo{required, EventId::echo} {}

    /// At a subscriber up to 2 wait.
    Subscription<bench::SmallBlockSlot, bench::SmallBlock> echo;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves bench::SmallBlocks from a component.
template <>
class Provided<bench::SmallBlocks> : public ProvidedBase {
  using Contract = bench::SmallBlocks;
  using EventId = bench::SmallBlocksEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of bench::SmallBlocks.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : echo{provided, EventId::echo} {}

    Emitter<bench::SmallBlockSlot, bench::SmallBlock> echo;
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
    bench::SmallBlock bounce_block{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

template <>
const InterfaceInfo& interfaceInfo<bench::LargeBlocks>();

/// Calls bench::LargeBlocks of another component.
template <>
class Required<bench::LargeBlocks> : public RequiredBase {
  using Contract = bench::LargeBlocks;
  using Id = bench::LargeBlocksCommand;
  using EventId = bench::LargeBlocksEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Client, server, client: sends the block back as the event echo.
  /// Write: up to 2 wait.
  Command<&Contract::bounce, bench::LargeBlocksBounceArguments> bounce{*this, Id::bounce};

  /// Subscribes to the events of bench::LargeBlocks.
  struct Events {
    explicit Events(RequiredBase& required)
        : echo{required, EventId::echo} {}

    /// At a subscriber up to 2 wait.
    Subscription<bench::LargeBlockSlot, bench::LargeBlock> echo;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves bench::LargeBlocks from a component.
template <>
class Provided<bench::LargeBlocks> : public ProvidedBase {
  using Contract = bench::LargeBlocks;
  using EventId = bench::LargeBlocksEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of bench::LargeBlocks.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : echo{provided, EventId::echo} {}

    Emitter<bench::LargeBlockSlot, bench::LargeBlock> echo;
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
    bench::LargeBlock bounce_block{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
