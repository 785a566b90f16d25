// Written by suturec from shapes/containers.h. Do not edit.
#pragma once

#include <suture/base/slots.h>
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

inline bool store(const Point& value, PointSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.x, slot.x);
  fits &= store(value.y, slot.y);
  return fits;
}

inline void load(const PointSlot& slot, Point& value) {
  using suture::load;
  load(slot.x, value.x);
  load(slot.y, value.y);
}

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

inline bool store(const Sequences& value, SequencesSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.bytes, slot.bytes);
  fits &= store(value.one, slot.one);
  fits &= store(value.row, slot.row);
  fits &= store(value.grid, slot.grid);
  fits &= store(value.corners, slot.corners);
  fits &= store(value.path, slot.path);
  fits &= store(value.bits, slot.bits);
  fits &= store(value.flags, slot.flags);
  fits &= store(value.numbers, slot.numbers);
  fits &= store(value.words, slot.words);
  fits &= store(value.levels, slot.levels);
  fits &= store(value.gains, slot.gains);
  fits &= store(value.points, slot.points);
  fits &= store(value.series, slot.series);
  fits &= store(value.shares, slot.shares);
  return fits;
}

inline void load(const SequencesSlot& slot, Sequences& value) {
  using suture::load;
  load(slot.bytes, value.bytes);
  load(slot.one, value.one);
  load(slot.row, value.row);
  load(slot.grid, value.grid);
  load(slot.corners, value.corners);
  load(slot.path, value.path);
  load(slot.bits, value.bits);
  load(slot.flags, value.flags);
  load(slot.numbers, value.numbers);
  load(slot.words, value.words);
  load(slot.levels, value.levels);
  load(slot.gains, value.gains);
  load(slot.points, value.points);
  load(slot.series, value.series);
  load(slot.shares, value.shares);
}

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
};

inline bool store(const Choices& value, ChoicesSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.gain, slot.gain);
  fits &= store(value.share, slot.share);
  fits &= store(value.answer, slot.answer);
  fits &= store(value.frame, slot.frame);
  fits &= store(value.target, slot.target);
  fits &= store(value.polygon, slot.polygon);
  fits &= store(value.twice, slot.twice);
  fits &= store(value.seen, slot.seen);
  fits &= store(value.entry, slot.entry);
  fits &= store(value.triple, slot.triple);
  fits &= store(value.either, slot.either);
  fits &= store(value.nested, slot.nested);
  fits &= store(value.owned, slot.owned);
  return fits;
}

inline void load(const ChoicesSlot& slot, Choices& value) {
  using suture::load;
  load(slot.gain, value.gain);
  load(slot.share, value.share);
  load(slot.answer, value.answer);
  load(slot.frame, value.frame);
  load(slot.target, value.target);
  load(slot.polygon, value.polygon);
  load(slot.twice, value.twice);
  load(slot.seen, value.seen);
  load(slot.entry, value.entry);
  load(slot.triple, value.triple);
  load(slot.either, value.either);
  load(slot.nested, value.nested);
  load(slot.owned, value.owned);
}

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

inline bool store(const Matrices& value, MatricesSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.joints, slot.joints);
  fits &= store(value.row, slot.row);
  fits &= store(value.any, slot.any);
  fits &= store(value.counts, slot.counts);
  fits &= store(value.columns, slot.columns);
  fits &= store(value.limited, slot.limited);
  fits &= store(value.fixed, slot.fixed);
  fits &= store(value.cloud, slot.cloud);
  fits &= store(value.wrenches, slot.wrenches);
  fits &= store(value.scaled, slot.scaled);
  fits &= store(value.wait, slot.wait);
  return fits;
}

inline void load(const MatricesSlot& slot, Matrices& value) {
  using suture::load;
  load(slot.joints, value.joints);
  load(slot.row, value.row);
  load(slot.any, value.any);
  load(slot.counts, value.counts);
  load(slot.columns, value.columns);
  load(slot.limited, value.limited);
  load(slot.fixed, value.fixed);
  load(slot.cloud, value.cloud);
  load(slot.wrenches, value.wrenches);
  load(slot.scaled, value.scaled);
  load(slot.wait, value.wait);
}

// --- Store: the arguments of its commands ---

struct StorePutArguments {
  SequencesSlot value;
};

inline bool store(const Sequences& value, StorePutArguments& slot) {
  using suture::store;
  return store(value, slot.value);
}

struct StoreChooseArguments {
  suture::SlotOptional<double> gain;
};

inline bool store(const std::optional<double>& gain, StoreChooseArguments& slot) {
  using suture::store;
  return store(gain, slot.gain);
}

/// The numbers of Store's commands in every table and record.
enum class StoreCommand : std::uint16_t {
  put,
  choose,
  sequences,
  choices,
  matrices,
  reading,
};

/// The numbers of Store's events.
enum class StoreEvent : std::uint16_t {
  changed,
};

}  // namespace shapes

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<shapes::Store>();

/// What a client of shapes::Store calls.
template <>
class Required<shapes::Store> : public RequiredBase {
  using Contract = shapes::Store;
  using Id = shapes::StoreCommand;
  using EventId = shapes::StoreEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  Command<&Contract::put, shapes::StorePutArguments> put{
      *this, static_cast<std::uint16_t>(Id::put)};
  Command<&Contract::choose, shapes::StoreChooseArguments> choose{
      *this, static_cast<std::uint16_t>(Id::choose)};
  ReadCommand<&Contract::sequences, shapes::SequencesSlot> sequences{
      *this, static_cast<std::uint16_t>(Id::sequences)};
  ReadCommand<&Contract::choices, shapes::ChoicesSlot> choices{
      *this, static_cast<std::uint16_t>(Id::choices)};
  ReadCommand<&Contract::matrices, shapes::MatricesSlot> matrices{
      *this, static_cast<std::uint16_t>(Id::matrices)};
  ReadCommand<&Contract::reading, suture::SlotTuple<double, std::int16_t>> reading{
      *this, static_cast<std::uint16_t>(Id::reading)};

  /// The events of shapes::Store, to subscribe to.
  struct Events {
    explicit Events(RequiredBase& required)
        : changed{required, static_cast<std::uint16_t>(EventId::changed)} {}

    Subscription<suture::SlotVariant<double, shapes::PointSlot>,
                 std::variant<double, shapes::Point>> changed;
  };
  Events& on() { return events_; }

 protected:
  // Of a contract that derives from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// What serves shapes::Store from a component.
template <>
class Provided<shapes::Store> : public ProvidedBase {
  using Contract = shapes::Store;
  using EventId = shapes::StoreEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// The events of shapes::Store, to emit.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : changed{provided, static_cast<std::uint16_t>(EventId::changed)} {}

    Emitter<suture::SlotVariant<double, shapes::PointSlot>,
            std::variant<double, shapes::Point>> changed;
  };
  Events& emit() { return events_; }

 protected:
  // Of a contract that derives from this one: `whole` points to its implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : ProvidedBase(owner, name, info, whole),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  // Reused by every command, so that what they own is allocated once.
  struct Scratch {
    shapes::Sequences put_value;
    std::optional<double> choose_gain;
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_{};
};

}  // namespace suture
