// Written by suturec from shapes/moments.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. moments.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slots.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "shapes/moments.h"

namespace shapes {

/// It has a time of each clock, of which only one is shifted.
struct MomentSlot {
  std::int64_t steady;  // suture::Time, ns
  std::int64_t system;  // std::chrono::system_clock::time_point, ns
  std::int64_t number;
};

bool store(const Moment& value, MomentSlot& slot);
void load(const MomentSlot& slot, Moment& value);
void shiftStamps(MomentSlot& slot, suture::Duration shift);

/// One in each container.
struct MomentsSlot {
  std::array<std::int64_t, 2> pair;
  suture::BoundedList<std::int64_t, 3> list;
  suture::BoundedList<MomentSlot, 2> moments;
  suture::BoundedList<suture::BoundedList<std::int64_t, 2>, 2> nested;
  suture::BoundedList<suture::SlotEntry<std::int32_t, std::int64_t>, 2> byNumber;
  suture::SlotOptional<std::int64_t> perhaps;
  suture::SlotOptional<MomentSlot> moment;
  suture::SlotTuple<std::int64_t, std::int64_t, MomentSlot> entry;
  suture::SlotVariant<std::int64_t, std::int64_t, MomentSlot> either;
};

bool store(const Moments& value, MomentsSlot& slot);
void load(const MomentsSlot& slot, Moments& value);
void reserve(const MomentsSlot*, Moments& value);
void shiftStamps(MomentsSlot& slot, suture::Duration shift);

/// Lasts as long as the types of C++ can count.
struct SpansSlot {
  double brief;    // std::chrono::duration<float, std::ratio<1, 1000>>
  double endless;  // std::chrono::duration<double>
  suture::BoundedList<double, 2> list;
};

bool store(const Spans& value, SpansSlot& slot);
void load(const SpansSlot& slot, Spans& value);
void reserve(const SpansSlot*, Spans& value);

bool isValid(const MomentSlot& slot, suture::FieldPath* path);
bool isValid(const MomentsSlot& slot, suture::FieldPath* path);
bool isValid(const SpansSlot& slot, suture::FieldPath* path);

// --- Journal: the arguments of its commands ---

struct JournalPutArguments {
  std::int64_t from;
  std::int64_t number;
};

bool store(const std::chrono::steady_clock::time_point& from, const std::int64_t& number,
           JournalPutArguments& slot);
void shiftStamps(JournalPutArguments& slot, suture::Duration shift);

struct JournalCountArguments {
  std::int64_t number;
};

bool store(const std::int64_t& number, JournalCountArguments& slot);

struct JournalFindArguments {
  std::int64_t number;
};

bool store(const std::int64_t& number, JournalFindArguments& slot);

// --- Journal: what its events carry ---

struct JournalChangedPayload {
  MomentSlot value;
  std::int64_t value2;
};

bool store(const Moment& value, const std::int64_t& value2, JournalChangedPayload& slot);
void load(const JournalChangedPayload& slot, Moment& value, std::int64_t& value2);
void shiftStamps(JournalChangedPayload& slot, suture::Duration shift);

/// Numbers the commands of Journal.
struct JournalCommand {
  static constexpr std::uint16_t put = 0;
  static constexpr std::uint16_t count = 1;
  static constexpr std::uint16_t latest = 2;
  static constexpr std::uint16_t moments = 3;
  static constexpr std::uint16_t find = 4;
};

/// Numbers the events of Journal.
struct JournalEvent {
  static constexpr std::uint16_t added = 0;
  static constexpr std::uint16_t changed = 1;
  static constexpr std::uint16_t counted = 2;
};

/// Numbers the reads of Journal as a row of the state has them.
struct JournalColumn {
  static constexpr std::uint16_t latest = 0;
  static constexpr std::uint16_t moments = 1;
};

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Moment& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Moment& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Moments& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Moments& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Spans& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Spans& value);

template <>
const InterfaceInfo& interfaceInfo<shapes::Journal>();

/// Calls shapes::Journal of another component.
template <>
class Required<shapes::Journal> : public RequiredBase {
  using Contract = shapes::Journal;
  using Id = shapes::JournalCommand;
  using EventId = shapes::JournalEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Write: up to 16 wait.
  Command<&Contract::put, shapes::JournalPutArguments> put{*this, Id::put};
  /// Write: up to 16 wait.
  Command<&Contract::count, shapes::JournalCountArguments> count{*this, Id::count};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::latest, std::int64_t> latest{*this, Id::latest};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::moments, shapes::MomentsSlot> moments{*this, Id::moments};
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::find, shapes::JournalFindArguments,
                       suture::SlotOptional<shapes::MomentSlot>> find{*this, Id::find};

  /// Subscribes to the events of shapes::Journal.
  struct Events {
    explicit Events(RequiredBase& required)
        : added{required, EventId::added},
          changed{required, EventId::changed},
          counted{required, EventId::counted} {}

    /// At a subscriber up to 16 wait.
    Subscription<std::int64_t, std::chrono::steady_clock::time_point> added;
    /// At a subscriber up to 16 wait.
    Subscription<shapes::JournalChangedPayload, shapes::Moment, std::int64_t> changed;
    /// At a subscriber up to 16 wait.
    Subscription<std::int64_t, std::int64_t> counted;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves shapes::Journal from a component.
template <>
class Provided<shapes::Journal> : public ProvidedBase {
  using Contract = shapes::Journal;
  using EventId = shapes::JournalEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of shapes::Journal.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : added{provided, EventId::added},
          changed{provided, EventId::changed},
          counted{provided, EventId::counted} {}

    Emitter<std::int64_t, std::chrono::steady_clock::time_point> added;
    Emitter<shapes::JournalChangedPayload, shapes::Moment, std::int64_t> changed;
    Emitter<std::int64_t, std::int64_t> counted;
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
    std::chrono::steady_clock::time_point put_from{};
    std::int64_t put_number{};
    std::int64_t count_number{};
    std::int64_t find_number{};
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_;
};

}  // namespace suture
