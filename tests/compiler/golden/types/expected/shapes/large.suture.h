// Written by suturec from shapes/large.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. large.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "shapes/large.h"

namespace shapes {

/// A list within whatever holds this.
struct TraceSlot {
  std::uint32_t channel;
  suture::BoundedList<double, 100> samples;
  double gain;
};

bool store(const Trace& value, TraceSlot& slot);
void load(const TraceSlot& slot, Trace& value);
void reserve(const TraceSlot*, Trace& value);

/// A large level in each place where one can be.
struct LargeSlot {
  double first;
  suture::BoundedText<300> text;
  suture::BoundedText<8> name;
  suture::BoundedList<TraceSlot, 5> traces;
  suture::BoundedMatrix<float, 20, 30> image;  // Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic>
  TraceSlot inner;
  suture::SlotOptional<TraceSlot> maybe;
  suture::SlotTuple<std::int8_t, TraceSlot, suture::BoundedList<std::int64_t, 40>> both;
  suture::BoundedList<suture::SlotEntry<std::uint16_t, double>, 50> gains;
  std::array<TraceSlot, 2> pair;
  suture::SlotVariant<suture::SlotNothing, TraceSlot, suture::BoundedList<float, 70>> choice;
  std::int64_t last;
};

bool store(const Large& value, LargeSlot& slot);
void load(const LargeSlot& slot, Large& value);
void reserve(const LargeSlot*, Large& value);

bool isValid(const TraceSlot& slot, suture::FieldPath* path);
bool isValid(const LargeSlot& slot, suture::FieldPath* path);

// --- Recorder: the arguments of its commands ---

struct RecorderKeepArguments {
  suture::BoundedList<double, 64> values;
  LargeSlot rest;
};

bool store(const std::vector<double>& values, const Large& rest, RecorderKeepArguments& slot);

struct RecorderRenameArguments {
  suture::BoundedText<8> name;
};

bool store(const std::string& name, RecorderRenameArguments& slot);

// --- Recorder: what its events carry ---

struct RecorderSaidPayload {
  std::int32_t value;
  LargeSlot value2;
};

bool store(const std::int32_t& value, const Large& value2, RecorderSaidPayload& slot);
void load(const RecorderSaidPayload& slot, std::int32_t& value, Large& value2);
void reserve(const RecorderSaidPayload*, std::int32_t& /*value*/, Large& value2);

/// Numbers the commands of Recorder.
struct RecorderCommand {
  static constexpr std::uint16_t keep = 0;
  static constexpr std::uint16_t rename = 1;
  static constexpr std::uint16_t kept = 2;
};

/// Numbers the events of Recorder.
struct RecorderEvent {
  static constexpr std::uint16_t heard = 0;
  static constexpr std::uint16_t said = 1;
};

/// Numbers the reads of Recorder as a row of the state has them.
struct RecorderColumn {
  static constexpr std::uint16_t kept = 0;
};

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Trace& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Trace& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Large& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Large& value);

template <>
const InterfaceInfo& interfaceInfo<shapes::Recorder>();

/// Calls shapes::Recorder of another component.
template <>
class Required<shapes::Recorder> : public RequiredBase {
  using Contract = shapes::Recorder;
  using Id = shapes::RecorderCommand;
  using EventId = shapes::RecorderEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Write: up to 16 wait.
  Command<&Contract::keep, shapes::RecorderKeepArguments> keep{*this, Id::keep};
  /// Write: up to 16 wait.
  Command<&Contract::rename, shapes::RecorderRenameArguments> rename{*this, Id::rename};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::kept, shapes::LargeSlot> kept{*this, Id::kept};

  /// Subscribes to the events of shapes::Recorder.
  struct Events {
    explicit Events(RequiredBase& required)
        : heard{required, EventId::heard},
          said{required, EventId::said} {}

    /// At a subscriber up to 16 wait.
    Subscription<shapes::TraceSlot, shapes::Trace> heard;
    /// At a subscriber up to 16 wait.
    Subscription<shapes::RecorderSaidPayload, std::int32_t, shapes::Large> said;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves shapes::Recorder from a component.
template <>
class Provided<shapes::Recorder> : public ProvidedBase {
  using Contract = shapes::Recorder;
  using EventId = shapes::RecorderEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of shapes::Recorder.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : heard{provided, EventId::heard},
          said{provided, EventId::said} {}

    Emitter<shapes::TraceSlot, shapes::Trace> heard;
    Emitter<shapes::RecorderSaidPayload, std::int32_t, shapes::Large> said;
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
    std::vector<double> keep_values{};
    shapes::Large keep_rest{};
    std::string rename_name{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
