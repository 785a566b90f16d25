// Written by suturec from suture/standard/collecting.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. collecting.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "suture/standard/collecting.h"

namespace suture {

/// Says what became of the rows or events of a time of collecting. Once the collector has caught up
/// with its provider, the three add up to what was produced.
struct CollectedCountsSlot {
  std::uint64_t collected;
  std::uint64_t passedOver;
  std::uint64_t missed;
};

bool store(const CollectedCounts& value, CollectedCountsSlot& slot);
void load(const CollectedCountsSlot& slot, CollectedCounts& value);

/// Says how much is collected.
struct CollectingIntervalSlot {
  std::uint32_t every;
  std::int64_t atLeast;  // std::chrono::nanoseconds, ns
};

bool store(const CollectingInterval& value, CollectingIntervalSlot& slot);
void load(const CollectingIntervalSlot& slot, CollectingInterval& value);

bool isValid(const CollectedCountsSlot& slot, suture::FieldPath* path);
bool isValid(const CollectingIntervalSlot& slot, suture::FieldPath* path);

// --- Collecting: the arguments of its commands ---

struct CollectingSetIntervalArguments {
  CollectingIntervalSlot interval;
};

bool store(const CollectingInterval& interval, CollectingSetIntervalArguments& slot);

/// Numbers the commands of Collecting.
struct CollectingCommand {
  static constexpr std::uint16_t start_collecting = 0;
  static constexpr std::uint16_t stop_collecting = 1;
  static constexpr std::uint16_t set_interval = 2;
  static constexpr std::uint16_t interval = 3;
  static constexpr std::uint16_t collecting = 4;
  static constexpr std::uint16_t counts = 5;
};

/// Numbers the reads of Collecting as a row of the state has them.
struct CollectingColumn {
  static constexpr std::uint16_t interval = 0;
  static constexpr std::uint16_t collecting = 1;
  static constexpr std::uint16_t counts = 2;
};

}  // namespace suture

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const suture::CollectedCounts& value);
template <>
Result<> decode(std::span<const std::byte> bytes, suture::CollectedCounts& value);

template <>
Result<std::vector<std::byte>> encode(const suture::CollectingInterval& value);
template <>
Result<> decode(std::span<const std::byte> bytes, suture::CollectingInterval& value);

template <>
const InterfaceInfo& interfaceInfo<suture::Collecting>();

/// Calls suture::Collecting of another component.
template <>
class Required<suture::Collecting> : public RequiredBase {
  using Contract = suture::Collecting;
  using Id = suture::CollectingCommand;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Begins to record what is produced from now on. Counts begin anew, unless it is collecting
  /// already.
  /// Void: up to 16 wait.
  Command<&Contract::start_collecting, NoSlot> start_collecting{*this, Id::start_collecting};
  /// Stops recording: what is produced from now on is discarded without being counted.
  /// Void: up to 16 wait.
  Command<&Contract::stop_collecting, NoSlot> stop_collecting{*this, Id::stop_collecting};
  /// Sets the interval from the next row or event on. Returns false, and changes nothing, for every
  /// 0th one or a negative time.
  /// Write with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::set_interval, suture::CollectingSetIntervalArguments,
                   std::uint8_t> set_interval{*this, Id::set_interval};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::interval, CollectingIntervalSlot> interval{*this, Id::interval};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::collecting, std::uint8_t> collecting{*this, Id::collecting};
  /// Counts what the present time of collecting has written, or the last one.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::counts, CollectedCountsSlot> counts{*this, Id::counts};

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}
};

/// Serves suture::Collecting from a component.
template <>
class Provided<suture::Collecting> : public ProvidedBase {
  using Contract = suture::Collecting;

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
    CollectingInterval set_interval_interval{};
  };

  Contract& implementation_;
  Scratch scratch_;
};

}  // namespace suture
