// Written by suturec from suture/standard/task_timing.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. task_timing.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "suture/standard/task_timing.h"

namespace suture {

struct DurationSummarySlot {
  std::int64_t mean;       // std::chrono::nanoseconds, ns
  std::int64_t deviation;  // std::chrono::nanoseconds, ns
  std::int64_t min;        // std::chrono::nanoseconds, ns
  std::int64_t max;        // std::chrono::nanoseconds, ns
  std::int64_t p99;        // std::chrono::nanoseconds, ns
};

bool store(const DurationSummary& value, DurationSummarySlot& slot);
void load(const DurationSummarySlot& slot, DurationSummary& value);

struct TaskWindowSlot {
  std::int64_t begin;  // suture::Time, ns
  std::int64_t end;    // suture::Time, ns
  std::uint64_t cycles;
  std::uint64_t skipped;
  DurationSummarySlot period;
  DurationSummarySlot compute;
};

bool store(const TaskWindow& value, TaskWindowSlot& slot);
void load(const TaskWindowSlot& slot, TaskWindow& value);
void shiftStamps(TaskWindowSlot& slot, suture::Duration shift);

bool isValid(const DurationSummarySlot& slot, suture::FieldPath* path);
bool isValid(const TaskWindowSlot& slot, suture::FieldPath* path);

/// Numbers the commands of TaskTiming.
struct TaskTimingCommand {
  static constexpr std::uint16_t window = 0;
  static constexpr std::uint16_t cycles = 1;
  static constexpr std::uint16_t skipped = 2;
};

/// Numbers the reads of TaskTiming as a row of the state has them.
struct TaskTimingColumn {
  static constexpr std::uint16_t window = 0;
  static constexpr std::uint16_t cycles = 1;
  static constexpr std::uint16_t skipped = 2;
};

}  // namespace suture

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const suture::DurationSummary& value);
template <>
Result<> decode(std::span<const std::byte> bytes, suture::DurationSummary& value);

template <>
Result<std::vector<std::byte>> encode(const suture::TaskWindow& value);
template <>
Result<> decode(std::span<const std::byte> bytes, suture::TaskWindow& value);

template <>
const InterfaceInfo& interfaceInfo<suture::TaskTiming>();

/// Calls suture::TaskTiming of another component.
template <>
class Required<suture::TaskTiming> : public RequiredBase {
  using Contract = suture::TaskTiming;
  using Id = suture::TaskTimingCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Returns the last whole window, of 1 s unless the task says otherwise; `end` is unset before
  /// the first.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::window, TaskWindowSlot> window{*this, Id::window};
  /// Counts the cycles since the task exists.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::cycles, std::uint64_t> cycles{*this, Id::cycles};
  /// Counts the periods or callbacks that passed without a cycle, since the task exists.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::skipped, std::uint64_t> skipped{*this, Id::skipped};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves suture::TaskTiming from a component.
template <>
class Provided<suture::TaskTiming> : public ProvidedBase {
  using Contract = suture::TaskTiming;

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
