// Written by suturec from shapes/containers.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. containers.suture.md has the reference.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slots.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "shapes/containers.h"

namespace shapes {

/// Parts of other types.
struct PointSlot {
  double x;  // m
  double y;
};

bool store(const Point& value, PointSlot& slot);
void load(const PointSlot& slot, Point& value);

/// Sequences, sets and maps.
struct SequencesSlot {
  suture::BoundedList<std::uint8_t, 8> bytes;
  std::uint8_t one;
  std::array<double, 3> row;
  std::array<std::array<std::int32_t, 3>, 2> grid;
  std::array<PointSlot, 2> corners;
  suture::BoundedList<PointSlot, 3> path;
  suture::BoundedList<std::uint8_t, 4> bits;
  suture::BoundedList<std::uint8_t, 4> flags;
  suture::BoundedList<std::int32_t, 4> numbers;
  suture::BoundedList<suture::BoundedText<6>, 3> words;
  suture::BoundedList<std::int16_t, 3> levels;
  suture::BoundedList<suture::SlotEntry<suture::BoundedText<6>, double>, 3> gains;
  suture::BoundedList<suture::SlotEntry<std::uint16_t, PointSlot>, 3> points;
  suture::BoundedList<suture::SlotEntry<suture::BoundedText<4>, suture::BoundedList<float, 3>>, 2> series;
  suture::BoundedList<suture::SlotEntry<std::int16_t, double>, 3> shares;
};

bool store(const Sequences& value, SequencesSlot& slot);
void load(const SequencesSlot& slot, Sequences& value);
void reserve(const SequencesSlot*, Sequences& value);

/// What holds one thing or another, or some of each.
struct ChoicesSlot {
  suture::SlotOptional<double> gain;
  suture::SlotOptional<double> share;
  suture::SlotOptional<std::uint8_t> answer;
  suture::SlotOptional<suture::BoundedText<8>> frame;
  suture::SlotOptional<PointSlot> target;
  suture::SlotOptional<suture::BoundedList<PointSlot, 2>> polygon;
  suture::SlotOptional<suture::SlotOptional<std::int32_t>> twice;
  suture::BoundedList<suture::SlotOptional<std::array<double, 3>>, 3> seen;
  suture::SlotTuple<std::int32_t, double> entry;
  suture::SlotTuple<std::uint8_t, suture::BoundedText<4>, PointSlot> triple;
  suture::SlotVariant<suture::SlotNothing, double, PointSlot, suture::BoundedText<4>, double> either;
  suture::SlotVariant<std::int16_t, suture::SlotOptional<PointSlot>> nested;
  suture::SlotOptional<PointSlot> owned;
  suture::SlotTuple<double, std::int16_t> rated;
};

bool store(const Choices& value, ChoicesSlot& slot);
void load(const ChoicesSlot& slot, Choices& value);
void reserve(const ChoicesSlot*, Choices& value);

/// Eigen types of all kinds.
struct MatricesSlot {
  suture::BoundedList<double, 4> joints;  // rad
  suture::BoundedList<double, 3> row;
  suture::BoundedMatrix<double, 2, 3> any;           // Eigen::MatrixXd
  suture::BoundedMatrix<std::int32_t, 2, 2> counts;  // Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic>
  suture::BoundedList<std::array<double, 3>, 4> columns;
  suture::BoundedList<float, 5> limited;
  std::array<double, 20> fixed;  // Eigen::Matrix<double, 4, 5>
  suture::BoundedList<std::array<double, 3>, 3> cloud;
  suture::BoundedList<std::array<float, 6>, 3> wrenches;
  std::array<double, 12> scaled;  // Eigen::Affine3d
  double wait;                    // std::chrono::duration<double, std::ratio<1, 1000>>
};

bool store(const Matrices& value, MatricesSlot& slot);
void load(const MatricesSlot& slot, Matrices& value);
void reserve(const MatricesSlot*, Matrices& value);

bool isKnownLevel(std::int16_t slot);
bool isValid(const PointSlot& slot, suture::FieldPath* path);
bool isValid(const SequencesSlot& slot, suture::FieldPath* path);
bool isValid(const ChoicesSlot& slot, suture::FieldPath* path);
bool isValid(const MatricesSlot& slot, suture::FieldPath* path);

// --- Store: the arguments of its commands ---

struct StorePutArguments {
  SequencesSlot value;
};

bool store(const Sequences& value, StorePutArguments& slot);

struct StoreChooseArguments {
  suture::SlotOptional<double> gain;
};

bool store(const std::optional<double>& gain, StoreChooseArguments& slot);

/// Numbers the commands of Store.
struct StoreCommand {
  static constexpr std::uint16_t put = 0;
  static constexpr std::uint16_t choose = 1;
  static constexpr std::uint16_t sequences = 2;
  static constexpr std::uint16_t choices = 3;
  static constexpr std::uint16_t matrices = 4;
  static constexpr std::uint16_t reading = 5;
};

/// Numbers the events of Store.
struct StoreEvent {
  static constexpr std::uint16_t changed = 0;
};

/// Numbers the reads of Store as a row of the state has them.
struct StoreColumn {
  static constexpr std::uint16_t sequences = 0;
  static constexpr std::uint16_t choices = 1;
  static constexpr std::uint16_t matrices = 2;
  static constexpr std::uint16_t reading = 3;
};

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Point& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Point& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Sequences& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Sequences& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Choices& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Choices& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Matrices& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Matrices& value);

template <>
const InterfaceInfo& interfaceInfo<shapes::Store>();

/// Calls shapes::Store of another component.
template <>
class Required<shapes::Store> : public RequiredBase {
  using Contract = shapes::Store;
  using Id = shapes::StoreCommand;
  using EventId = shapes::StoreEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Write: up to 16 wait.
  Command<&Contract::put, shapes::StorePutArguments> put{*this, Id::put};
  /// Write: up to 16 wait.
  Command<&Contract::choose, shapes::StoreChooseArguments> choose{*this, Id::choose};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::sequences, shapes::SequencesSlot> sequences{*this, Id::sequences};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::choices, shapes::ChoicesSlot> choices{*this, Id::choices};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::matrices, shapes::MatricesSlot> matrices{*this, Id::matrices};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::reading, suture::SlotTuple<double, std::int16_t>> reading{
      *this, Id::reading};

  /// Subscribes to the events of shapes::Store.
  struct Events {
    explicit Events(RequiredBase& required)
        : changed{required, EventId::changed} {}

    /// At a subscriber up to 16 wait.
    Subscription<suture::SlotVariant<double, shapes::PointSlot>,
                 std::variant<double, shapes::Point>> changed;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves shapes::Store from a component.
template <>
class Provided<shapes::Store> : public ProvidedBase {
  using Contract = shapes::Store;
  using EventId = shapes::StoreEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of shapes::Store.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : changed{provided, EventId::changed} {}

    Emitter<suture::SlotVariant<double, shapes::PointSlot>,
            std::variant<double, shapes::Point>> changed;
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
    shapes::Sequences put_value{};
    std::optional<double> choose_gain{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
