// Written by suturec from unit/shm/logbook.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. logbook.suture.md has the reference.
#pragma once

#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "unit/shm/logbook.h"

namespace logs {

// --- Counter: the arguments of its commands ---

struct CounterCountArguments {
  std::int32_t entries;
};

bool store(const std::int32_t& entries, CounterCountArguments& slot);

/// Numbers the commands of Counter.
struct CounterCommand {
  static constexpr std::uint16_t count = 0;
  static constexpr std::uint16_t entries = 1;
};

/// Numbers the reads of Counter as a row of the state has them.
struct CounterColumn {
  static constexpr std::uint16_t entries = 0;
};

/// Numbers the commands of Logbook, behind those that it inherits.
struct LogbookCommand {
  static constexpr std::uint16_t text = 2;
};

/// Numbers the reads of Logbook as a row of the state has them.
struct LogbookColumn {
  static constexpr std::uint16_t entries = 0;
  static constexpr std::uint16_t text = 1;
};

}  // namespace logs

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<logs::Counter>();

/// Calls logs::Counter of another component.
template <>
class Required<logs::Counter> : public RequiredBase {
  using Contract = logs::Counter;
  using Id = logs::CounterCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Write: up to 16 wait.
  Command<&Contract::count, logs::CounterCountArguments> count{*this, Id::count};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::entries, std::int32_t> entries{*this, Id::entries};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves logs::Counter from a component.
template <>
class Provided<logs::Counter> : public ProvidedBase {
  using Contract = logs::Counter;

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
    std::int32_t count_entries{};
  };

  Contract& implementation_;
  Scratch scratch_;
};

template <>
const InterfaceInfo& interfaceInfo<logs::Logbook>();

/// Calls logs::Logbook of another component.
template <>
class Required<logs::Logbook> : public Required<logs::Counter> {
  using Contract = logs::Logbook;
  using Id = logs::LogbookCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::text, suture::OpenText> text{*this, Id::text};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : Required<logs::Counter>(owner, name, info) {}
};

/// Serves logs::Logbook from a component.
template <>
class Provided<logs::Logbook> : public Provided<logs::Counter> {
  using Contract = logs::Logbook;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : Provided<logs::Counter>(owner, name, info, whole, implementation),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  struct Dispatch;  // has a function for each command

  Contract& implementation_;
};

}  // namespace suture
