// Written by suturec from shapes/containers.h. Do not edit.
#include "shapes/containers.suture.h"

#include <suture/wire/codec.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "shapes/containers.capnp.h"

namespace shapes {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<Level>, std::int16_t>);
static_assert(static_cast<std::int16_t>(Level::Unknown) == -1);
static_assert(static_cast<std::int16_t>(Level::Low) == 10);
static_assert(static_cast<std::int16_t>(Level::High) == 300);
static_assert(std::is_same_v<decltype(Point::x), double>);
static_assert(std::is_same_v<decltype(Point::y), double>);
static_assert(std::is_same_v<decltype(Sequences::bytes), std::vector<std::byte>>);
static_assert(std::is_same_v<decltype(Sequences::one), std::byte>);
static_assert(std::is_same_v<decltype(Sequences::row), double[3]>);
static_assert(std::is_same_v<decltype(Sequences::grid), std::int32_t[2][3]>);
static_assert(std::is_same_v<decltype(Sequences::corners), Point[2]>);
static_assert(std::is_same_v<decltype(Sequences::path), std::deque<shapes::Point>>);
static_assert(std::is_same_v<decltype(Sequences::bits), std::deque<bool>>);
static_assert(std::is_same_v<decltype(Sequences::flags), std::vector<bool>>);
static_assert(std::is_same_v<decltype(Sequences::numbers), std::set<std::int32_t>>);
static_assert(std::is_same_v<decltype(Sequences::words), std::unordered_set<std::string>>);
static_assert(std::is_same_v<decltype(Sequences::levels), std::set<shapes::Level>>);
static_assert(std::is_same_v<decltype(Sequences::gains), std::map<std::string, double>>);
static_assert(std::is_same_v<decltype(Sequences::points),
                             std::unordered_map<std::uint16_t, shapes::Point>>);
static_assert(std::is_same_v<decltype(Sequences::series),
                             std::map<std::string, std::vector<float>>>);
static_assert(std::is_same_v<decltype(Sequences::shares), std::map<shapes::Level, double>>);
static_assert(std::is_same_v<decltype(Choices::gain), std::optional<double>>);
static_assert(std::is_same_v<decltype(Choices::share), std::optional<double>>);
static_assert(std::is_same_v<decltype(Choices::answer), std::optional<bool>>);
static_assert(std::is_same_v<decltype(Choices::frame), std::optional<std::string>>);
static_assert(std::is_same_v<decltype(Choices::target), std::optional<shapes::Point>>);
static_assert(std::is_same_v<decltype(Choices::polygon),
                             std::optional<std::vector<shapes::Point>>>);
static_assert(std::is_same_v<decltype(Choices::twice), std::optional<std::optional<std::int32_t>>>);
static_assert(std::is_same_v<decltype(Choices::seen), std::vector<std::optional<Eigen::Vector3d>>>);
static_assert(std::is_same_v<decltype(Choices::entry), std::pair<std::int32_t, double>>);
static_assert(std::is_same_v<decltype(Choices::triple),
                             std::tuple<bool, std::string, shapes::Point>>);
static_assert(std::is_same_v<decltype(Choices::either),
                             std::variant<std::monostate, double, shapes::Point, std::string, double>>);
static_assert(std::is_same_v<decltype(Choices::nested),
                             std::variant<shapes::Level, std::optional<shapes::Point>>>);
static_assert(std::is_same_v<decltype(Choices::owned), std::unique_ptr<shapes::Point>>);
static_assert(std::is_same_v<decltype(Choices::rated), std::pair<double, shapes::Level>>);
static_assert(std::is_same_v<decltype(Matrices::joints), Eigen::VectorXd>);
static_assert(std::is_same_v<decltype(Matrices::row), Eigen::RowVectorXd>);
static_assert(std::is_same_v<decltype(Matrices::any), Eigen::MatrixXd>);
static_assert(std::is_same_v<decltype(Matrices::counts),
                             Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic>>);
static_assert(std::is_same_v<decltype(Matrices::columns),
                             Eigen::Matrix<double, 3, Eigen::Dynamic>>);
static_assert(std::is_same_v<decltype(Matrices::limited),
                             Eigen::Matrix<float, Eigen::Dynamic, 1, 0, 5, 1>>);
static_assert(std::is_same_v<decltype(Matrices::fixed), Eigen::Matrix<double, 4, 5>>);
static_assert(std::is_same_v<decltype(Matrices::cloud), std::vector<Eigen::Vector3d>>);
static_assert(std::is_same_v<decltype(Matrices::wrenches), std::deque<Eigen::Matrix<float, 6, 1>>>);
static_assert(std::is_same_v<decltype(Matrices::scaled), Eigen::Affine3d>);
static_assert(std::is_same_v<decltype(Matrices::wait),
                             std::chrono::duration<double, std::ratio<1, 1000>>>);

}  // namespace

bool store(const Point& value, PointSlot& slot) {
  bool fits = true;
  fits &= store(value.x, slot.x);
  fits &= store(value.y, slot.y);
  return fits;
}

void load(const PointSlot& slot, Point& value) {
  load(slot.x, value.x);
  load(slot.y, value.y);
}

bool store(const Sequences& value, SequencesSlot& slot) {
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

void load(const SequencesSlot& slot, Sequences& value) {
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

void reserve(const SequencesSlot*, Sequences& value) {
  suture::reserveFor<decltype(SequencesSlot::bytes)>(value.bytes);
  suture::reserveFor<decltype(SequencesSlot::flags)>(value.flags);
}

bool store(const Choices& value, ChoicesSlot& slot) {
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
  fits &= store(value.rated, slot.rated);
  return fits;
}

void load(const ChoicesSlot& slot, Choices& value) {
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
  load(slot.rated, value.rated);
}

void reserve(const ChoicesSlot*, Choices& value) {
  suture::reserveFor<decltype(ChoicesSlot::seen)>(value.seen);
}

bool store(const Matrices& value, MatricesSlot& slot) {
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

void load(const MatricesSlot& slot, Matrices& value) {
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

void reserve(const MatricesSlot*, Matrices& value) {
  suture::reserveFor<decltype(MatricesSlot::cloud)>(value.cloud);
}

bool store(const Sequences& value, StorePutArguments& slot) { return store(value, slot.value); }

bool store(const std::optional<double>& gain, StoreChooseArguments& slot) {
  return store(gain, slot.gain);
}

// --- between slots and Cap'n Proto

wire::Level wireLevel(std::int16_t slot) {
  switch (static_cast<Level>(slot)) {
    case Level::Unknown: return wire::Level::UNKNOWN;
    case Level::Low: return wire::Level::LOW;
    case Level::High: return wire::Level::HIGH;
  }
  return wire::Level{};
}

bool isKnownLevel(std::int16_t slot) {
  switch (static_cast<Level>(slot)) {
    case Level::Unknown:
    case Level::Low:
    case Level::High:
      return true;
  }
  return false;
}

suture::Errc fromWire(wire::Level in, std::int16_t& slot) {
  switch (in) {
    case wire::Level::UNKNOWN: return slot =
        static_cast<std::int16_t>(Level::Unknown), suture::Errc{};
    case wire::Level::LOW: return slot = static_cast<std::int16_t>(Level::Low), suture::Errc{};
    case wire::Level::HIGH: return slot = static_cast<std::int16_t>(Level::High), suture::Errc{};
  }
  return slot = static_cast<std::int16_t>(Level::Unknown), suture::Errc{};
}

void toWire(const PointSlot& slot, wire::Point::Builder out) {
  out.setX(slot.x);
  out.setY(slot.y);
}

suture::Errc fromWire(wire::Point::Reader in, PointSlot& slot, suture::Duration) {
  slot.x = in.getX();
  slot.y = in.getY();
  return suture::Errc{};
}

bool isValid(const PointSlot& slot, suture::FieldPath* path) {
  if (!suture::rpc::inRange(slot.x, -10, 10)) return suture::refusedAt(path, "x");
  return isValid(slot.y) || suture::refusedAt(path, "y");
}

void toWire(const suture::SlotEntry<suture::BoundedText<6>, double>& slot,
            wire::ShapesContainersEntryOfTextToFloat64::Builder out) {
  toWire(slot.key, out.initKey(sizeOf(slot.key)));
  out.setValue(slot.value);
}

suture::Errc fromWire(wire::ShapesContainersEntryOfTextToFloat64::Reader in,
                      suture::SlotEntry<suture::BoundedText<6>, double>& slot, suture::Duration) {
  slot.value = in.getValue();
  return fromWire(in.getKey(), slot.key);
}

void toWire(const suture::SlotEntry<std::uint16_t, PointSlot>& slot,
            wire::ShapesContainersEntryOfUInt16ToPoint::Builder out) {
  out.setKey(slot.key);
  toWire(slot.value, out.initValue());
}

suture::Errc fromWire(wire::ShapesContainersEntryOfUInt16ToPoint::Reader in,
                      suture::SlotEntry<std::uint16_t, PointSlot>& slot, suture::Duration shift) {
  slot.key = in.getKey();
  return fromWire(in.getValue(), slot.value, shift);
}

void toWire(const suture::SlotEntry<suture::BoundedText<4>, suture::BoundedList<float, 3>>& slot,
            wire::ShapesContainersEntryOfTextToListOfFloat32::Builder out) {
  toWire(slot.key, out.initKey(sizeOf(slot.key)));
  toWire(slot.value, out.initValue(sizeOf(slot.value)));
}

suture::Errc fromWire(wire::ShapesContainersEntryOfTextToListOfFloat32::Reader in,
                      suture::SlotEntry<suture::BoundedText<4>, suture::BoundedList<float, 3>>& slot,
                      suture::Duration) {
  return suture::rpc::firstError({
      fromWire(in.getKey(), slot.key),
      fromWire(in.getValue(), slot.value),
  });
}

void toWire(const suture::SlotEntry<std::int16_t, double>& slot,
            wire::ShapesContainersEntryOfLevelToFloat64::Builder out) {
  out.setKey(wireLevel(slot.key));
  out.setValue(slot.value);
}

suture::Errc fromWire(wire::ShapesContainersEntryOfLevelToFloat64::Reader in,
                      suture::SlotEntry<std::int16_t, double>& slot, suture::Duration) {
  slot.value = in.getValue();
  return fromWire(in.getKey(), slot.key);
}

void toWire(const SequencesSlot& slot, wire::Sequences::Builder out) {
  toWire(slot.bytes, out.initBytes(sizeOf(slot.bytes)));
  out.setOne(slot.one);
  toWire(slot.row, out.initRow(3));
  suture::rpc::toWireList(slot.grid, out.initGrid(2),
                          [](const std::array<std::int32_t, 3>& element, auto list, std::uint32_t i) {
                            toWire(element, list.init(i, 3));
                          });
  suture::rpc::toWireList(slot.corners, out.initCorners(2),
                          [](const PointSlot& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
  suture::rpc::toWireList(slot.path, out.initPath(sizeOf(slot.path)),
                          [](const PointSlot& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
  toWire(slot.bits, out.initBits(sizeOf(slot.bits)));
  toWire(slot.flags, out.initFlags(sizeOf(slot.flags)));
  toWire(slot.numbers, out.initNumbers(sizeOf(slot.numbers)));
  toWire(slot.words, out.initWords(sizeOf(slot.words)));
  suture::rpc::toWireList(slot.levels, out.initLevels(sizeOf(slot.levels)),
                          [](const std::int16_t& element, auto list, std::uint32_t i) {
                            list.set(i, wireLevel(element));
                          });
  suture::rpc::toWireList(slot.gains, out.initGains(sizeOf(slot.gains)),
                          [](const auto& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
  suture::rpc::toWireList(slot.points, out.initPoints(sizeOf(slot.points)),
                          [](const auto& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
  suture::rpc::toWireList(slot.series, out.initSeries(sizeOf(slot.series)),
                          [](const auto& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
  suture::rpc::toWireList(slot.shares, out.initShares(sizeOf(slot.shares)),
                          [](const auto& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
}

suture::Errc fromWire(wire::Sequences::Reader in, SequencesSlot& slot, suture::Duration shift) {
  slot.one = in.getOne();
  return suture::rpc::firstError({
      fromWire(in.getBytes(), slot.bytes),
      fromWire(in.getRow(), slot.row),
      suture::rpc::fromWireList(in.getGrid(), slot.grid,
                                [](auto item, std::array<std::int32_t, 3>& target) {
                                  return fromWire(item, target);
                                }),
      suture::rpc::fromWireList(in.getCorners(), slot.corners, [&](auto item, PointSlot& target) {
        return fromWire(item, target, shift);
      }),
      suture::rpc::fromWireList(in.getPath(), slot.path, [&](auto item, PointSlot& target) {
        return fromWire(item, target, shift);
      }),
      fromWire(in.getBits(), slot.bits),
      fromWire(in.getFlags(), slot.flags),
      suture::rpc::fromWireDistinct(in.getNumbers(), slot.numbers,
                                    [](auto item, std::int32_t& target) {
                                      return target = item, suture::Errc{};
                                    }),
      suture::rpc::fromWireDistinct(in.getWords(), slot.words,
                                    [](auto item, suture::BoundedText<6>& target) {
                                      return fromWire(item, target);
                                    }),
      suture::rpc::fromWireDistinct(in.getLevels(), slot.levels,
                                    [](auto item, std::int16_t& target) {
                                      return fromWire(item, target);
                                    }),
      suture::rpc::fromWireDistinct(in.getGains(), slot.gains, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
      suture::rpc::fromWireDistinct(in.getPoints(), slot.points, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
      suture::rpc::fromWireDistinct(in.getSeries(), slot.series, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
      suture::rpc::fromWireDistinct(in.getShares(), slot.shares, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
  });
}

bool isValid(const SequencesSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.row, path)) return suture::refusedAt(path, "row");
  if (!suture::rpc::allOf(slot.corners, path, [path](const PointSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "corners");
  }
  if (!suture::rpc::allOf(slot.path, path, [path](const PointSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "path");
  }
  if (!suture::rpc::allOf(slot.levels, path, [](const std::int16_t& element) {
    return isKnownLevel(element);
  })) {
    return suture::refusedAt(path, "levels");
  }
  if (!isValid(slot.gains, path)) return suture::refusedAt(path, "gains");
  if (!isValid(slot.points, path)) return suture::refusedAt(path, "points");
  if (!isValid(slot.series, path)) return suture::refusedAt(path, "series");
  if (!suture::rpc::allOf(slot.shares, path,
                          [](const suture::SlotEntry<std::int16_t, double>& element) {
                            return isKnownLevel(element.key) && suture::rpc::inRange(element.value, 0, 1);
                          })) {
    return suture::refusedAt(path, "shares");
  }
  return true;
}

void toWire(const suture::SlotOptional<double>& slot,
            wire::ShapesContainersOptionalFloat64::Builder out) {
  if (slot.present == 0) return out.setNone();
  out.setSome(slot.value);
}

suture::Errc fromWire(wire::ShapesContainersOptionalFloat64::Reader in,
                      suture::SlotOptional<double>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  slot.value = in.getSome();
  return suture::Errc{};
}

void toWire(const suture::SlotOptional<std::uint8_t>& slot,
            wire::ShapesContainersOptionalBool::Builder out) {
  if (slot.present == 0) return out.setNone();
  out.setSome(slot.value != 0);
}

suture::Errc fromWire(wire::ShapesContainersOptionalBool::Reader in,
                      suture::SlotOptional<std::uint8_t>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  slot.value = in.getSome();
  return suture::Errc{};
}

void toWire(const suture::SlotOptional<suture::BoundedText<8>>& slot,
            wire::ShapesContainersOptionalText::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome(sizeOf(slot.value)));
}

suture::Errc fromWire(wire::ShapesContainersOptionalText::Reader in,
                      suture::SlotOptional<suture::BoundedText<8>>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value);
}

void toWire(const suture::SlotOptional<PointSlot>& slot,
            wire::ShapesContainersOptionalPoint::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome());
}

suture::Errc fromWire(wire::ShapesContainersOptionalPoint::Reader in,
                      suture::SlotOptional<PointSlot>& slot, suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value, shift);
}

void toWire(const suture::SlotOptional<suture::BoundedList<PointSlot, 2>>& slot,
            wire::ShapesContainersOptionalListOfPoint::Builder out) {
  if (slot.present == 0) return out.setNone();
  suture::rpc::toWireList(slot.value, out.initSome(sizeOf(slot.value)),
                          [](const PointSlot& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
}

suture::Errc fromWire(wire::ShapesContainersOptionalListOfPoint::Reader in,
                      suture::SlotOptional<suture::BoundedList<PointSlot, 2>>& slot,
                      suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return suture::rpc::fromWireList(in.getSome(), slot.value, [&](auto item, PointSlot& target) {
    return fromWire(item, target, shift);
  });
}

void toWire(const suture::SlotOptional<std::int32_t>& slot,
            wire::ShapesContainersOptionalInt32::Builder out) {
  if (slot.present == 0) return out.setNone();
  out.setSome(slot.value);
}

suture::Errc fromWire(wire::ShapesContainersOptionalInt32::Reader in,
                      suture::SlotOptional<std::int32_t>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  slot.value = in.getSome();
  return suture::Errc{};
}

void toWire(const suture::SlotOptional<suture::SlotOptional<std::int32_t>>& slot,
            wire::ShapesContainersOptionalOptionalInt32::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome());
}

suture::Errc fromWire(wire::ShapesContainersOptionalOptionalInt32::Reader in,
                      suture::SlotOptional<suture::SlotOptional<std::int32_t>>& slot,
                      suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value, shift);
}

void toWire(const suture::SlotOptional<std::array<double, 3>>& slot,
            wire::ShapesContainersOptionalVec3::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome());
}

suture::Errc fromWire(wire::ShapesContainersOptionalVec3::Reader in,
                      suture::SlotOptional<std::array<double, 3>>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value);
}

void toWire(const suture::SlotTuple<std::int32_t, double>& slot,
            wire::ShapesContainersTupleOfInt32AndFloat64::Builder out) {
  out.setItem0(suture::item<0>(slot));
  out.setItem1(suture::item<1>(slot));
}

suture::Errc fromWire(wire::ShapesContainersTupleOfInt32AndFloat64::Reader in,
                      suture::SlotTuple<std::int32_t, double>& slot, suture::Duration) {
  suture::item<0>(slot) = in.getItem0();
  suture::item<1>(slot) = in.getItem1();
  return suture::Errc{};
}

void toWire(const suture::SlotTuple<std::uint8_t, suture::BoundedText<4>, PointSlot>& slot,
            wire::ShapesContainersTupleOfBoolAndTextAndPoint::Builder out) {
  out.setItem0(suture::item<0>(slot) != 0);
  toWire(suture::item<1>(slot), out.initItem1(sizeOf(suture::item<1>(slot))));
  toWire(suture::item<2>(slot), out.initItem2());
}

suture::Errc fromWire(wire::ShapesContainersTupleOfBoolAndTextAndPoint::Reader in,
                      suture::SlotTuple<std::uint8_t, suture::BoundedText<4>, PointSlot>& slot,
                      suture::Duration shift) {
  suture::item<0>(slot) = in.getItem0();
  return suture::rpc::firstError({
      fromWire(in.getItem1(), suture::item<1>(slot)),
      fromWire(in.getItem2(), suture::item<2>(slot), shift),
  });
}

void toWire(const suture::SlotVariant<suture::SlotNothing, double, PointSlot, suture::BoundedText<4>, double>& slot,
            wire::ShapesContainersEitherOfNothingOrFloat64OrPointOrTextOrFloat64::Builder out) {
  if (slot.index == 0) return out.setNothing();
  if (slot.index == 1) return out.setFloat64(suture::alternative<1>(slot));
  if (slot.index == 2) return toWire(suture::alternative<2>(slot), out.initPoint());
  if (slot.index == 3) return toWire(suture::alternative<3>(slot),
                                     out.initText(sizeOf(suture::alternative<3>(slot))));
  if (slot.index == 4) return out.setFloat64At4(suture::alternative<4>(slot));
}

suture::Errc fromWire(wire::ShapesContainersEitherOfNothingOrFloat64OrPointOrTextOrFloat64::Reader in,
                      suture::SlotVariant<suture::SlotNothing, double, PointSlot, suture::BoundedText<4>, double>& slot,
                      suture::Duration shift) {
  if (in.isNothing()) {
    slot.index = 0;
    return suture::Errc{};
  }
  if (in.isFloat64()) {
    slot.index = 1;
    suture::alternative<1>(slot) = in.getFloat64();
    return suture::Errc{};
  }
  if (in.isPoint()) {
    slot.index = 2;
    return fromWire(in.getPoint(), suture::alternative<2>(slot), shift);
  }
  if (in.isText()) {
    slot.index = 3;
    return fromWire(in.getText(), suture::alternative<3>(slot));
  }
  if (in.isFloat64At4()) {
    slot.index = 4;
    suture::alternative<4>(slot) = in.getFloat64At4();
    return suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const suture::SlotVariant<std::int16_t, suture::SlotOptional<PointSlot>>& slot,
            wire::ShapesContainersEitherOfLevelOrOptionalPoint::Builder out) {
  if (slot.index == 0) return out.setLevel(wireLevel(suture::alternative<0>(slot)));
  if (slot.index == 1) return toWire(suture::alternative<1>(slot), out.initOptionalPoint());
}

suture::Errc fromWire(wire::ShapesContainersEitherOfLevelOrOptionalPoint::Reader in,
                      suture::SlotVariant<std::int16_t, suture::SlotOptional<PointSlot>>& slot,
                      suture::Duration shift) {
  if (in.isLevel()) {
    slot.index = 0;
    return fromWire(in.getLevel(), suture::alternative<0>(slot));
  }
  if (in.isOptionalPoint()) {
    slot.index = 1;
    return fromWire(in.getOptionalPoint(), suture::alternative<1>(slot), shift);
  }
  return suture::Errc::Invalid;
}

void toWire(const suture::SlotTuple<double, std::int16_t>& slot,
            wire::ShapesContainersTupleOfFloat64AndLevel::Builder out) {
  out.setItem0(suture::item<0>(slot));
  out.setItem1(wireLevel(suture::item<1>(slot)));
}

suture::Errc fromWire(wire::ShapesContainersTupleOfFloat64AndLevel::Reader in,
                      suture::SlotTuple<double, std::int16_t>& slot, suture::Duration) {
  suture::item<0>(slot) = in.getItem0();
  return fromWire(in.getItem1(), suture::item<1>(slot));
}

void toWire(const ChoicesSlot& slot, wire::Choices::Builder out) {
  toWire(slot.gain, out.initGain());
  toWire(slot.share, out.initShare());
  toWire(slot.answer, out.initAnswer());
  toWire(slot.frame, out.initFrame());
  toWire(slot.target, out.initTarget());
  toWire(slot.polygon, out.initPolygon());
  toWire(slot.twice, out.initTwice());
  suture::rpc::toWireList(slot.seen, out.initSeen(sizeOf(slot.seen)),
                          [](const auto& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
  toWire(slot.entry, out.initEntry());
  toWire(slot.triple, out.initTriple());
  toWire(slot.either, out.initEither());
  toWire(slot.nested, out.initNested());
  toWire(slot.owned, out.initOwned());
  toWire(slot.rated, out.initRated());
}

suture::Errc fromWire(wire::Choices::Reader in, ChoicesSlot& slot, suture::Duration shift) {
  return suture::rpc::firstError({
      fromWire(in.getGain(), slot.gain, shift),
      fromWire(in.getShare(), slot.share, shift),
      fromWire(in.getAnswer(), slot.answer, shift),
      fromWire(in.getFrame(), slot.frame, shift),
      fromWire(in.getTarget(), slot.target, shift),
      fromWire(in.getPolygon(), slot.polygon, shift),
      fromWire(in.getTwice(), slot.twice, shift),
      suture::rpc::fromWireList(in.getSeen(), slot.seen, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
      fromWire(in.getEntry(), slot.entry, shift),
      fromWire(in.getTriple(), slot.triple, shift),
      fromWire(in.getEither(), slot.either, shift),
      fromWire(in.getNested(), slot.nested, shift),
      fromWire(in.getOwned(), slot.owned, shift),
      fromWire(in.getRated(), slot.rated, shift),
  });
}

bool isValid(const ChoicesSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.gain, path)) return suture::refusedAt(path, "gain");
  if (!suture::rpc::allOf(slot.share, path, [](const double& element) {
    return suture::rpc::inRange(element, 0, 1);
  })) {
    return suture::refusedAt(path, "share");
  }
  if (!isValid(slot.target, path)) return suture::refusedAt(path, "target");
  if (!isValid(slot.polygon, path)) return suture::refusedAt(path, "polygon");
  if (!suture::rpc::allOf(slot.seen, path,
                          [path](const suture::SlotOptional<std::array<double, 3>>& element) {
                            return isValid(element, path);
                          })) {
    return suture::refusedAt(path, "seen");
  }
  if (!isValid(slot.entry, path)) return suture::refusedAt(path, "entry");
  if (!isValid(slot.triple, path)) return suture::refusedAt(path, "triple");
  if (!isValid(slot.either, path)) return suture::refusedAt(path, "either");
  if (!suture::rpc::theOneOf(slot.nested, path, isKnownLevel, suture::rpc::Valid{path})) {
    return suture::refusedAt(path, "nested");
  }
  if (!isValid(slot.owned, path)) return suture::refusedAt(path, "owned");
  return suture::rpc::allItems(slot.rated, path, suture::rpc::Valid{path}, isKnownLevel) ||
      suture::refusedAt(path, "rated");
}

void toWire(const MatricesSlot& slot, wire::Matrices::Builder out) {
  toWire(slot.joints, out.initJoints(sizeOf(slot.joints)));
  toWire(slot.row, out.initRow(sizeOf(slot.row)));
  toWire(slot.any, out.initAny());
  toWire(slot.counts, out.initCounts());
  suture::rpc::toWireFlat(slot.columns, out.initColumns(sizeOf(slot.columns) * 3));
  toWire(slot.limited, out.initLimited(sizeOf(slot.limited)));
  toWire(slot.fixed, out.initFixed(20));
  suture::rpc::toWireFlat(slot.cloud, out.initCloud(sizeOf(slot.cloud) * 3));
  suture::rpc::toWireFlat(slot.wrenches, out.initWrenches(sizeOf(slot.wrenches) * 6));
  toWire(slot.scaled, out.initScaled());
  out.setWait(slot.wait);
}

suture::Errc fromWire(wire::Matrices::Reader in, MatricesSlot& slot, suture::Duration) {
  slot.wait = in.getWait();
  return suture::rpc::firstError({
      fromWire(in.getJoints(), slot.joints),
      fromWire(in.getRow(), slot.row),
      fromWire(in.getAny(), slot.any),
      fromWire(in.getCounts(), slot.counts),
      suture::rpc::fromWireFlat(in.getColumns(), slot.columns),
      fromWire(in.getLimited(), slot.limited),
      in.getFixed().size() != 0 ? fromWire(in.getFixed(), slot.fixed)
          : suture::rpc::fromDefault(Matrices().fixed, slot.fixed),
      suture::rpc::fromWireFlat(in.getCloud(), slot.cloud),
      suture::rpc::fromWireFlat(in.getWrenches(), slot.wrenches),
      in.hasScaled() ? suture::rpc::fromWireAffine(in.getScaled(), slot.scaled)
          : suture::rpc::fromDefault(Matrices().scaled, slot.scaled),
  });
}

bool isValid(const MatricesSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.joints, path)) return suture::refusedAt(path, "joints");
  if (!isValid(slot.row, path)) return suture::refusedAt(path, "row");
  if (!isValid(slot.any)) return suture::refusedAt(path, "any");
  if (!suture::rpc::allOf(slot.columns, path, [path](const std::array<double, 3>& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "columns");
  }
  if (!isValid(slot.limited, path)) return suture::refusedAt(path, "limited");
  if (!isValid(slot.fixed)) return suture::refusedAt(path, "fixed");
  if (!suture::rpc::allOf(slot.cloud, path, [path](const std::array<double, 3>& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "cloud");
  }
  if (!suture::rpc::allOf(slot.wrenches, path, [path](const std::array<float, 6>& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "wrenches");
  }
  if (!isValid(slot.scaled)) return suture::refusedAt(path, "scaled");
  return isValid(slot.wait) || suture::refusedAt(path, "wait");
}

void toWire(const suture::SlotVariant<double, PointSlot>& slot,
            wire::ShapesContainersEitherOfFloat64OrPoint::Builder out) {
  if (slot.index == 0) return out.setFloat64(suture::alternative<0>(slot));
  if (slot.index == 1) return toWire(suture::alternative<1>(slot), out.initPoint());
}

suture::Errc fromWire(wire::ShapesContainersEitherOfFloat64OrPoint::Reader in,
                      suture::SlotVariant<double, PointSlot>& slot, suture::Duration shift) {
  if (in.isFloat64()) {
    slot.index = 0;
    suture::alternative<0>(slot) = in.getFloat64();
    return suture::Errc{};
  }
  if (in.isPoint()) {
    slot.index = 1;
    return fromWire(in.getPoint(), suture::alternative<1>(slot), shift);
  }
  return suture::Errc::Invalid;
}

namespace {

bool acceptsStorePut(const StorePutArguments& slot, suture::FieldPath* path) {
  return isValid(slot.value, path) || suture::refusedAt(path, "value");
}

bool acceptsStoreChoose(const StoreChooseArguments& slot, suture::FieldPath* path) {
  return isValid(slot.gain, path) || suture::refusedAt(path, "gain");
}

bool acceptsStoreReadingResult(const suture::SlotTuple<double, std::int16_t>& slot,
                               suture::FieldPath* path) {
  return suture::rpc::allItems(slot, path, suture::rpc::Valid{path}, isKnownLevel);
}

bool acceptsStoreChangedEvent(const suture::SlotVariant<double, PointSlot>& slot,
                              suture::FieldPath* path) {
  return isValid(slot, path);
}

// --- Store as Cap'n Proto

void encodeStorePut(const StorePutArguments& slot, wire::Store::PutParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeStorePut(wire::Store::PutParams::Reader in, StorePutArguments& slot,
                            suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeStoreChoose(const StoreChooseArguments& slot, wire::Store::ChooseParams::Builder out) {
  toWire(slot.gain, out.initGain());
}
suture::Errc decodeStoreChoose(wire::Store::ChooseParams::Reader in, StoreChooseArguments& slot,
                               suture::Duration shift) {
  return fromWire(in.getGain(), slot.gain, shift);
}

void encodeStoreSequencesResult(const SequencesSlot& slot,
                                wire::Store::SequencesResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeStoreSequencesResult(wire::Store::SequencesResults::Reader in,
                                        SequencesSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeStoreChoicesResult(const ChoicesSlot& slot, wire::Store::ChoicesResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeStoreChoicesResult(wire::Store::ChoicesResults::Reader in, ChoicesSlot& slot,
                                      suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeStoreMatricesResult(const MatricesSlot& slot,
                               wire::Store::MatricesResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeStoreMatricesResult(wire::Store::MatricesResults::Reader in, MatricesSlot& slot,
                                       suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeStoreReadingResult(const suture::SlotTuple<double, std::int16_t>& slot,
                              wire::Store::ReadingResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeStoreReadingResult(wire::Store::ReadingResults::Reader in,
                                      suture::SlotTuple<double, std::int16_t>& slot,
                                      suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeStoreChangedEvent(const suture::SlotVariant<double, PointSlot>& slot,
                             wire::StoreEvents::ChangedParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeStoreChangedEvent(wire::StoreEvents::ChangedParams::Reader in,
                                     suture::SlotVariant<double, PointSlot>& slot,
                                     suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeStoreSequencesColumn(const SequencesSlot& slot, wire::StoreStateRow::Builder out) {
  toWire(slot, out.initSequences());
}
suture::Errc decodeStoreSequencesColumn(wire::StoreStateRow::Reader in, SequencesSlot& slot,
                                        suture::Duration shift) {
  return in.hasSequences() ? fromWire(in.getSequences(), slot, shift) : suture::Errc::Invalid;
}

void encodeStoreChoicesColumn(const ChoicesSlot& slot, wire::StoreStateRow::Builder out) {
  toWire(slot, out.initChoices());
}
suture::Errc decodeStoreChoicesColumn(wire::StoreStateRow::Reader in, ChoicesSlot& slot,
                                      suture::Duration shift) {
  return in.hasChoices() ? fromWire(in.getChoices(), slot, shift) : suture::Errc::Invalid;
}

void encodeStoreMatricesColumn(const MatricesSlot& slot, wire::StoreStateRow::Builder out) {
  toWire(slot, out.initMatrices());
}
suture::Errc decodeStoreMatricesColumn(wire::StoreStateRow::Reader in, MatricesSlot& slot,
                                       suture::Duration shift) {
  return in.hasMatrices() ? fromWire(in.getMatrices(), slot, shift) : suture::Errc::Invalid;
}

void encodeStoreReadingColumn(const suture::SlotTuple<double, std::int16_t>& slot,
                              wire::StoreStateRow::Builder out) {
  toWire(slot, out.initReading());
}
suture::Errc decodeStoreReadingColumn(wire::StoreStateRow::Reader in,
                                      suture::SlotTuple<double, std::int16_t>& slot,
                                      suture::Duration shift) {
  return in.hasReading() ? fromWire(in.getReading(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeStoreColumn(unsigned column, const std::byte* memory, wire::StoreStateRow::Builder out) {
  switch (static_cast<StoreColumn>(column)) {
    case StoreColumn::sequences:
      return encodeStoreSequencesColumn(suture::slotIn<SequencesSlot>(memory), out);
    case StoreColumn::choices:
      return encodeStoreChoicesColumn(suture::slotIn<ChoicesSlot>(memory), out);
    case StoreColumn::matrices:
      return encodeStoreMatricesColumn(suture::slotIn<MatricesSlot>(memory), out);
    case StoreColumn::reading:
      return encodeStoreReadingColumn(
          suture::slotIn<suture::SlotTuple<double, std::int16_t>>(memory), out);
  }
}
suture::Errc decodeStoreColumn(wire::StoreStateRow::Reader in, unsigned column, std::byte* memory,
                               suture::Duration shift) {
  switch (static_cast<StoreColumn>(column)) {
    case StoreColumn::sequences:
      return decodeStoreSequencesColumn(in, suture::newSlot<SequencesSlot>(memory), shift);
    case StoreColumn::choices:
      return decodeStoreChoicesColumn(in, suture::newSlot<ChoicesSlot>(memory), shift);
    case StoreColumn::matrices:
      return decodeStoreMatricesColumn(in, suture::newSlot<MatricesSlot>(memory), shift);
    case StoreColumn::reading:
      return decodeStoreReadingColumn(in,
                                      suture::newSlot<suture::SlotTuple<double, std::int16_t>>(memory),
                                      shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::rpc::CommandCodec kStoreCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Store>(),
     .method = 1,
     .sent = suture::rpc::sentIn<wire::Store::PutParams>,
     .arguments = suture::rpc::messageOf<wire::Store::PutParams, StorePutArguments, encodeStorePut,
                                         decodeStorePut>},
    {.interface = capnp::typeId<wire::Store>(),
     .method = 2,
     .sent = suture::rpc::sentIn<wire::Store::ChooseParams>,
     .arguments = suture::rpc::messageOf<wire::Store::ChooseParams, StoreChooseArguments,
                                         encodeStoreChoose, decodeStoreChoose>},
    {.interface = capnp::typeId<wire::Store>(),
     .method = 3,
     .sent = suture::rpc::sentIn<wire::Store::SequencesParams>,
     .result = suture::rpc::messageOf<wire::Store::SequencesResults, SequencesSlot,
                                      encodeStoreSequencesResult, decodeStoreSequencesResult>,
     .stamp = suture::rpc::stampIn<wire::Store::SequencesResults>},
    {.interface = capnp::typeId<wire::Store>(),
     .method = 4,
     .sent = suture::rpc::sentIn<wire::Store::ChoicesParams>,
     .result = suture::rpc::messageOf<wire::Store::ChoicesResults, ChoicesSlot,
                                      encodeStoreChoicesResult, decodeStoreChoicesResult>,
     .stamp = suture::rpc::stampIn<wire::Store::ChoicesResults>},
    {.interface = capnp::typeId<wire::Store>(),
     .method = 5,
     .sent = suture::rpc::sentIn<wire::Store::MatricesParams>,
     .result = suture::rpc::messageOf<wire::Store::MatricesResults, MatricesSlot,
                                      encodeStoreMatricesResult, decodeStoreMatricesResult>,
     .stamp = suture::rpc::stampIn<wire::Store::MatricesResults>},
    {.interface = capnp::typeId<wire::Store>(),
     .method = 6,
     .sent = suture::rpc::sentIn<wire::Store::ReadingParams>,
     .result = suture::rpc::messageOf<wire::Store::ReadingResults,
                                      suture::SlotTuple<double, std::int16_t>,
                                      encodeStoreReadingResult, decodeStoreReadingResult>,
     .stamp = suture::rpc::stampIn<wire::Store::ReadingResults>},
};

constexpr suture::rpc::EventCodec kStoreEventCodecs[] = {
    {.method = 1,
     .stamp = suture::rpc::stampIn<wire::StoreEvents::ChangedParams>,
     .payload = suture::rpc::messageOf<wire::StoreEvents::ChangedParams,
                                       suture::SlotVariant<double, PointSlot>,
                                       encodeStoreChangedEvent, decodeStoreChangedEvent>},
};

const suture::rpc::Codec& storeCodec() {
  static constexpr suture::rpc::Codec kCodec{
      .schema = suture::rpc::schemaOf<wire::Store>,
      .contract = capnp::typeId<wire::Store>(),
      .subscriber = capnp::typeId<wire::StoreEvents>(),
      .commands = kStoreCommandCodecs,
      .events = kStoreEventCodecs,
      .row = suture::rpc::rowOf<wire::StoreEvents::StateParams, wire::StoreStateRow,
                                encodeStoreColumn, decodeStoreColumn>,
  };
  return kCodec;
}

constexpr suture::CommandInfo kStoreCommands[] = {
    {.name = "put",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<StorePutArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<StorePutArguments, acceptsStorePut>},
    {.name = "choose",
     .kind = suture::CommandKind::Write,
     .argumentsSize = suture::slotSize<StoreChooseArguments>,
     .depth = 16,
     .accepts = suture::checkSlot<StoreChooseArguments, acceptsStoreChoose>},
    {.name = "sequences",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<SequencesSlot>,
     .depth = 16,
     .column = static_cast<int>(StoreColumn::sequences),
     .acceptsResult = suture::checkSlot<SequencesSlot, isValid>},
    {.name = "choices",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<ChoicesSlot>,
     .depth = 16,
     .column = static_cast<int>(StoreColumn::choices),
     .acceptsResult = suture::checkSlot<ChoicesSlot, isValid>},
    {.name = "matrices",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<MatricesSlot>,
     .depth = 16,
     .column = static_cast<int>(StoreColumn::matrices),
     .acceptsResult = suture::checkSlot<MatricesSlot, isValid>},
    {.name = "reading",
     .kind = suture::CommandKind::Read,
     .resultSize = suture::slotSize<suture::SlotTuple<double, std::int16_t>>,
     .depth = 16,
     .column = static_cast<int>(StoreColumn::reading),
     .acceptsResult = suture::checkSlot<suture::SlotTuple<double, std::int16_t>, acceptsStoreReadingResult>},
};

constexpr suture::EventInfo kStoreEvents[] = {
    {.name = "changed",
     .payloadSize = suture::slotSize<suture::SlotVariant<double, PointSlot>>,
     .depth = 16,
     .accepts = suture::checkSlot<suture::SlotVariant<double, PointSlot>, acceptsStoreChangedEvent>},
};

// The self-description, as in shapes/containers.suture.json.
constexpr char kStoreDescription[] = R"json(
{"name": "shapes::Store", "doc": "Composites right in a contract.",
"hash": "5839ad6669a078a7c2d8c90f1fd4ac0e", "commands": [{"name": "put", "kind": "write",
"ordinal": 1, "parameters": [{"name": "value", "type": {"kind": "struct",
"name": "shapes::Sequences"}}], "queue": 16}, {"name": "choose", "kind": "write", "ordinal": 2,
"parameters": [{"name": "gain", "type": {"kind": "optional", "element": {"kind": "Float64"}}}],
"queue": 16}, {"name": "sequences", "kind": "read", "ordinal": 3, "result": {"type": {
"kind": "struct", "name": "shapes::Sequences"}}, "queue": 16}, {"name": "choices", "kind": "read",
"ordinal": 4, "result": {"type": {"kind": "struct", "name": "shapes::Choices"}}, "queue": 16}, {
"name": "matrices", "kind": "read", "ordinal": 5, "result": {"type": {"kind": "struct",
"name": "shapes::Matrices"}}, "queue": 16}, {"name": "reading", "kind": "read", "ordinal": 6,
"result": {"type": {"kind": "tuple", "elements": [{"kind": "Float64"}, {"kind": "enum",
"name": "shapes::Level"}]}}, "queue": 16}], "events": [{"name": "changed", "kind": "write",
"ordinal": 1, "payload": {"type": {"kind": "variant", "alternatives": [{"kind": "Float64"}, {
"kind": "struct", "name": "shapes::Point"}]}}, "queue": 16}], "enums": [{"name": "shapes::Level",
"doc": "Sparse, negative, and ready for what later versions add.", "underlying": "Int16",
"enumerators": [{"name": "Unknown", "value": -1, "wire": "unknown", "fallback": true}, {
"name": "Low", "value": 10, "wire": "low"}, {"name": "High", "value": 300, "wire": "high"}]}],
"structs": [{"name": "shapes::Point", "doc": "Parts of other types.", "fields": [{"name": "x",
"type": {"kind": "Float64"}, "unit": "m", "range": [-10.0, 10.0], "default": 0.0}, {"name": "y",
"type": {"kind": "Float64"}, "default": 0.0}]}, {"name": "shapes::Sequences",
"doc": "Sequences, sets and maps.", "fields": [{"name": "bytes", "type": {"kind": "list",
"element": {"kind": "UInt8"}, "capacity": 8}}, {"name": "one", "type": {"kind": "UInt8"}}, {
"name": "row", "type": {"kind": "array", "element": {"kind": "Float64"}, "length": 3}}, {
"name": "grid", "type": {"kind": "array", "element": {"kind": "array", "element": {"kind": "Int32"
}, "length": 3}, "length": 2}}, {"name": "corners", "type": {"kind": "array", "element": {
"kind": "struct", "name": "shapes::Point"}, "length": 2}}, {"name": "path", "type": {
"kind": "list", "element": {"kind": "struct", "name": "shapes::Point"}, "capacity": 3}}, {
"name": "bits", "type": {"kind": "list", "element": {"kind": "Bool"}, "capacity": 4}}, {
"name": "flags", "type": {"kind": "list", "element": {"kind": "Bool"}, "capacity": 4}}, {
"name": "numbers", "type": {"kind": "set", "element": {"kind": "Int32"}, "capacity": 4}}, {
"name": "words", "type": {"kind": "set", "element": {"kind": "text", "capacity": 6}, "capacity": 3}
}, {"name": "levels", "type": {"kind": "set", "element": {"kind": "enum", "name": "shapes::Level"},
"capacity": 3}}, {"name": "gains", "type": {"kind": "map", "key": {"kind": "text", "capacity": 6},
"value": {"kind": "Float64"}, "capacity": 3}}, {"name": "points", "type": {"kind": "map", "key": {
"kind": "UInt16"}, "value": {"kind": "struct", "name": "shapes::Point"}, "capacity": 3}}, {
"name": "series", "type": {"kind": "map", "key": {"kind": "text", "capacity": 4}, "value": {
"kind": "list", "element": {"kind": "Float32"}, "capacity": 3}, "capacity": 2}}, {"name": "shares",
"type": {"kind": "map", "key": {"kind": "enum", "name": "shapes::Level"}, "value": {
"kind": "Float64"}, "capacity": 3}, "range": [0.0, 1.0]}]}, {"name": "shapes::Choices",
"doc": "What holds one thing or another, or some of each.", "fields": [{"name": "gain", "type": {
"kind": "optional", "element": {"kind": "Float64"}}}, {"name": "share", "type": {
"kind": "optional", "element": {"kind": "Float64"}}, "range": [0.0, 1.0]}, {"name": "answer",
"type": {"kind": "optional", "element": {"kind": "Bool"}}}, {"name": "frame", "type": {
"kind": "optional", "element": {"kind": "text", "capacity": 8}}}, {"name": "target", "type": {
"kind": "optional", "element": {"kind": "struct", "name": "shapes::Point"}}}, {"name": "polygon",
"type": {"kind": "optional", "element": {"kind": "list", "element": {"kind": "struct",
"name": "shapes::Point"}, "capacity": 2}}}, {"name": "twice", "type": {"kind": "optional",
"element": {"kind": "optional", "element": {"kind": "Int32"}}}}, {"name": "seen", "type": {
"kind": "list", "element": {"kind": "optional", "element": {"kind": "matrix", "scalar": "Float64",
"rows": 3, "columns": 1}}, "capacity": 3}}, {"name": "entry", "type": {"kind": "tuple",
"elements": [{"kind": "Int32"}, {"kind": "Float64"}]}}, {"name": "triple", "type": {
"kind": "tuple", "elements": [{"kind": "Bool"}, {"kind": "text", "capacity": 4}, {"kind": "struct",
"name": "shapes::Point"}]}}, {"name": "either", "type": {"kind": "variant", "alternatives": [{
"kind": "nothing"}, {"kind": "Float64"}, {"kind": "struct", "name": "shapes::Point"}, {
"kind": "text", "capacity": 4}, {"kind": "Float64"}]}}, {"name": "nested", "type": {
"kind": "variant", "alternatives": [{"kind": "enum", "name": "shapes::Level"}, {"kind": "optional",
"element": {"kind": "struct", "name": "shapes::Point"}}]}}, {"name": "owned", "type": {
"kind": "optional", "element": {"kind": "struct", "name": "shapes::Point"}}}, {"name": "rated",
"type": {"kind": "tuple", "elements": [{"kind": "Float64"}, {"kind": "enum", "name": "shapes::Level"
}]}}]}, {"name": "shapes::Matrices", "doc": "Eigen types of all kinds.", "fields": [{
"name": "joints", "type": {"kind": "list", "element": {"kind": "Float64"}, "capacity": 4},
"unit": "rad"}, {"name": "row", "type": {"kind": "list", "element": {"kind": "Float64"},
"capacity": 3}}, {"name": "any", "type": {"kind": "any matrix", "scalar": "Float64", "capacity": [
2, 3]}}, {"name": "counts", "type": {"kind": "any matrix", "scalar": "Int32", "capacity": [2, 2]}},
{"name": "columns", "type": {"kind": "list", "element": {"kind": "matrix", "scalar": "Float64",
"rows": 3, "columns": 1}, "capacity": 4}}, {"name": "limited", "type": {"kind": "list", "element": {
"kind": "Float32"}, "capacity": 5}}, {"name": "fixed", "type": {"kind": "matrix",
"scalar": "Float64", "rows": 4, "columns": 5}}, {"name": "cloud", "type": {"kind": "list",
"element": {"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 1}, "capacity": 3}}, {
"name": "wrenches", "type": {"kind": "list", "element": {"kind": "matrix", "scalar": "Float32",
"rows": 6, "columns": 1}, "capacity": 3}}, {"name": "scaled", "type": {"kind": "affine",
"scalar": "Float64"}}, {"name": "wait", "type": {"kind": "duration", "period": "1/1000",
"scalar": "Float64"}, "default": 0.0}]}], "wire": [{"id": "@0xbb0be3e4bb1e6be9",
"kind": "interface", "name": "Store", "cxx": "shapes::Store", "members": [{"at": 0,
"name": "subscribe", "parameters": [{"at": 0, "name": "events", "is": "@0xe1e2cc5c73c90fe5"}, {
"at": 1, "name": "eventMask", "is": "UInt64"}, {"at": 2, "name": "stateMask", "is": "UInt64"}]}, {
"at": 1, "name": "put", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "value",
"is": "@0xdd7a64a833e189af"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 2, "name": "choose", "is": "kind \"write\"", "parameters": [{"at": 0, "name": "gain",
"is": "@0x9a6cebde1c465fb4"}, {"at": 1, "name": "sent", "is": "/suture/rpc.capnp:Sent"}]}, {
"at": 3, "name": "sequences", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xdd7a64a833e189af"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 4, "name": "choices", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xbda4c87a7b3da61e"}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {
"at": 5, "name": "matrices", "is": "kind \"read\"", "parameters": [{"at": 0, "name": "sent",
"is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0, "name": "value", "is": "@0xd5b880c1c2797353"
}, {"at": 1, "name": "stamp", "is": "Int64"}]}, {"at": 6, "name": "reading", "is": "kind \"read\"",
"parameters": [{"at": 0, "name": "sent", "is": "/suture/rpc.capnp:Sent"}], "results": [{"at": 0,
"name": "value", "is": "@0xfdb609e41c4ccca5"}, {"at": 1, "name": "stamp", "is": "Int64"}]}]}, {
"id": "@0xe1e2cc5c73c90fe5", "kind": "interface", "name": "StoreEvents", "members": [{"at": 0,
"name": "state", "parameters": [{"at": 0, "name": "row", "is": "@0xca120faf75e33fa7"}]}, {"at": 1,
"name": "changed", "parameters": [{"at": 0, "name": "value", "is": "@0x8f220204a5e1de49"}, {
"at": 1, "name": "stamp", "is": "Int64"}]}]}, {"id": "@0xca120faf75e33fa7", "kind": "struct",
"name": "StoreStateRow", "members": [{"at": 0, "name": "stamp", "is": "Int64"}, {"at": 1,
"name": "evaluated", "is": "UInt64"}, {"at": 2, "name": "tooLarge", "is": "UInt64"}, {"at": 3,
"name": "sequences", "is": "@0xdd7a64a833e189af"}, {"at": 4, "name": "choices",
"is": "@0xbda4c87a7b3da61e"}, {"at": 5, "name": "matrices", "is": "@0xd5b880c1c2797353"}, {"at": 6,
"name": "reading", "is": "@0xfdb609e41c4ccca5"}]}, {"id": "@0xdd7a64a833e189af", "kind": "struct",
"name": "Sequences", "members": [{"at": 0, "name": "bytes", "is": "Data"}, {"at": 1, "name": "one",
"is": "UInt8"}, {"at": 2, "name": "row", "is": "List(Float64) shape \"3\""}, {"at": 3,
"name": "grid", "is": "List(List(Int32)) shape \"2,3\""}, {"at": 4, "name": "corners",
"is": "List(@0xb51a57f43829556b) shape \"2\""}, {"at": 5, "name": "path",
"is": "List(@0xb51a57f43829556b)"}, {"at": 6, "name": "bits", "is": "List(Bool)"}, {"at": 7,
"name": "flags", "is": "List(Bool)"}, {"at": 8, "name": "numbers", "is": "List(Int32)"}, {"at": 9,
"name": "words", "is": "List(Text)"}, {"at": 10, "name": "levels", "is": "List(@0xa46142666f1d7c70)"
}, {"at": 11, "name": "gains", "is": "List(@0xe48709dcb204eab3)"}, {"at": 12, "name": "points",
"is": "List(@0x802b99a8ef527e43)"}, {"at": 13, "name": "series", "is": "List(@0xe8944577cbd7d345)"
}, {"at": 14, "name": "shares", "is": "List(@0xd457ac67cfb958f3)"}]}, {"id": "@0xb51a57f43829556b",
"kind": "struct", "name": "Point", "members": [{"at": 0, "name": "x", "is": "Float64 unit \"m\""}, {
"at": 1, "name": "y", "is": "Float64"}]}, {"id": "@0xa46142666f1d7c70", "kind": "enum",
"name": "Level", "members": [{"at": 0, "name": "unknown"}, {"at": 1, "name": "low"}, {"at": 2,
"name": "high"}]}, {"id": "@0xe48709dcb204eab3", "kind": "struct",
"name": "ShapesContainersEntryOfTextToFloat64", "members": [{"at": 0, "name": "key", "is": "Text"},
{"at": 1, "name": "value", "is": "Float64"}]}, {"id": "@0x802b99a8ef527e43", "kind": "struct",
"name": "ShapesContainersEntryOfUInt16ToPoint", "members": [{"at": 0, "name": "key", "is": "UInt16"
}, {"at": 1, "name": "value", "is": "@0xb51a57f43829556b"}]}, {"id": "@0xe8944577cbd7d345",
"kind": "struct", "name": "ShapesContainersEntryOfTextToListOfFloat32", "members": [{"at": 0,
"name": "key", "is": "Text"}, {"at": 1, "name": "value", "is": "List(Float32)"}]}, {
"id": "@0xd457ac67cfb958f3", "kind": "struct", "name": "ShapesContainersEntryOfLevelToFloat64",
"members": [{"at": 0, "name": "key", "is": "@0xa46142666f1d7c70"}, {"at": 1, "name": "value",
"is": "Float64"}]}, {"id": "@0xbda4c87a7b3da61e", "kind": "struct", "name": "Choices", "members": [
{"at": 0, "name": "gain", "is": "@0x9a6cebde1c465fb4"}, {"at": 1, "name": "share",
"is": "@0x9a6cebde1c465fb4"}, {"at": 2, "name": "answer", "is": "@0x87471a777724acdf"}, {"at": 3,
"name": "frame", "is": "@0xa13ea2f47ac175b5"}, {"at": 4, "name": "target",
"is": "@0x93456d793990e99b"}, {"at": 5, "name": "polygon", "is": "@0x87412f55480b65f2"}, {"at": 6,
"name": "twice", "is": "@0x997d382cf61c2bb6"}, {"at": 7, "name": "seen",
"is": "List(@0x93f6eb2708268fd2)"}, {"at": 8, "name": "entry", "is": "@0xa8fca31255af753f"}, {
"at": 9, "name": "triple", "is": "@0xd1cc96f9d5534dc0"}, {"at": 10, "name": "either",
"is": "@0xaf3aba732f52a3c6"}, {"at": 11, "name": "nested", "is": "@0xb44eaa716e9d1cae"}, {"at": 12,
"name": "owned", "is": "@0x93456d793990e99b"}, {"at": 13, "name": "rated",
"is": "@0xfdb609e41c4ccca5"}]}, {"id": "@0x9a6cebde1c465fb4", "kind": "union",
"name": "ShapesContainersOptionalFloat64", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "Float64"}]}, {"id": "@0x87471a777724acdf", "kind": "union",
"name": "ShapesContainersOptionalBool", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "Bool"}]}, {"id": "@0xa13ea2f47ac175b5", "kind": "union",
"name": "ShapesContainersOptionalText", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "Text"}]}, {"id": "@0x93456d793990e99b", "kind": "union",
"name": "ShapesContainersOptionalPoint", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "@0xb51a57f43829556b"}]}, {"id": "@0x87412f55480b65f2",
"kind": "union", "name": "ShapesContainersOptionalListOfPoint", "members": [{"at": 0,
"name": "none", "is": "Void"}, {"at": 1, "name": "some", "is": "List(@0xb51a57f43829556b)"}]}, {
"id": "@0x997d382cf61c2bb6", "kind": "union", "name": "ShapesContainersOptionalOptionalInt32",
"members": [{"at": 0, "name": "none", "is": "Void"}, {"at": 1, "name": "some",
"is": "@0x89f4ac8eee93a31a"}]}, {"id": "@0x89f4ac8eee93a31a", "kind": "union",
"name": "ShapesContainersOptionalInt32", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "Int32"}]}, {"id": "@0x93f6eb2708268fd2", "kind": "union",
"name": "ShapesContainersOptionalVec3", "members": [{"at": 0, "name": "none", "is": "Void"}, {
"at": 1, "name": "some", "is": "/suture/types.capnp:Vec3"}]}, {"id": "@0xa8fca31255af753f",
"kind": "struct", "name": "ShapesContainersTupleOfInt32AndFloat64", "members": [{"at": 0,
"name": "item0", "is": "Int32"}, {"at": 1, "name": "item1", "is": "Float64"}]}, {
"id": "@0xd1cc96f9d5534dc0", "kind": "struct", "name": "ShapesContainersTupleOfBoolAndTextAndPoint",
"members": [{"at": 0, "name": "item0", "is": "Bool"}, {"at": 1, "name": "item1", "is": "Text"}, {
"at": 2, "name": "item2", "is": "@0xb51a57f43829556b"}]}, {"id": "@0xaf3aba732f52a3c6",
"kind": "union", "name": "ShapesContainersEitherOfNothingOrFloat64OrPointOrTextOrFloat64",
"members": [{"at": 0, "name": "nothing", "is": "Void"}, {"at": 1, "name": "float64", "is": "Float64"
}, {"at": 2, "name": "point", "is": "@0xb51a57f43829556b"}, {"at": 3, "name": "text", "is": "Text"
}, {"at": 4, "name": "float64At4", "is": "Float64"}]}, {"id": "@0xb44eaa716e9d1cae",
"kind": "union", "name": "ShapesContainersEitherOfLevelOrOptionalPoint", "members": [{"at": 0,
"name": "level", "is": "@0xa46142666f1d7c70"}, {"at": 1, "name": "optionalPoint",
"is": "@0x93456d793990e99b"}]}, {"id": "@0xfdb609e41c4ccca5", "kind": "struct",
"name": "ShapesContainersTupleOfFloat64AndLevel", "members": [{"at": 0, "name": "item0",
"is": "Float64"}, {"at": 1, "name": "item1", "is": "@0xa46142666f1d7c70"}]}, {
"id": "@0xd5b880c1c2797353", "kind": "struct", "name": "Matrices", "members": [{"at": 0,
"name": "joints", "is": "List(Float64) unit \"rad\""}, {"at": 1, "name": "row",
"is": "List(Float64)"}, {"at": 2, "name": "any", "is": "@0xe30c2c9ae5b373ec"}, {"at": 3,
"name": "counts", "is": "@0xcf91b55ab5eb9027"}, {"at": 4, "name": "columns",
"is": "List(Float64) shape \"*,3x1\""}, {"at": 5, "name": "limited", "is": "List(Float32)"}, {
"at": 6, "name": "fixed", "is": "List(Float64) shape \"4x5\""}, {"at": 7, "name": "cloud",
"is": "List(Float64) shape \"*,3x1\""}, {"at": 8, "name": "wrenches",
"is": "List(Float32) shape \"*,6x1\""}, {"at": 9, "name": "scaled",
"is": "/suture/types.capnp:Pose shape \"affine\""}, {"at": 10, "name": "wait",
"is": "Float64 period \"1/1000\""}]}, {"id": "@0xe30c2c9ae5b373ec", "kind": "struct",
"name": "ShapesContainersAnyMatrixOfFloat64", "members": [{"at": 0, "name": "rows", "is": "UInt32"
}, {"at": 1, "name": "columns", "is": "UInt32"}, {"at": 2, "name": "data", "is": "List(Float64)"}]
}, {"id": "@0xcf91b55ab5eb9027", "kind": "struct", "name": "ShapesContainersAnyMatrixOfInt32",
"members": [{"at": 0, "name": "rows", "is": "UInt32"}, {"at": 1, "name": "columns", "is": "UInt32"
}, {"at": 2, "name": "data", "is": "List(Int32)"}]}, {"id": "@0x8f220204a5e1de49", "kind": "union",
"name": "ShapesContainersEitherOfFloat64OrPoint", "members": [{"at": 0, "name": "float64",
"is": "Float64"}, {"at": 1, "name": "point", "is": "@0xb51a57f43829556b"}]}]})json";

}  // namespace
}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Point& value) {
  return rpc::encodeAs<shapes::wire::Point, shapes::PointSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Point& value) {
  return rpc::decodeAs<shapes::wire::Point, shapes::PointSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Sequences& value) {
  return rpc::encodeAs<shapes::wire::Sequences, shapes::SequencesSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Sequences& value) {
  return rpc::decodeAs<shapes::wire::Sequences, shapes::SequencesSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Choices& value) {
  return rpc::encodeAs<shapes::wire::Choices, shapes::ChoicesSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Choices& value) {
  return rpc::decodeAs<shapes::wire::Choices, shapes::ChoicesSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Matrices& value) {
  return rpc::encodeAs<shapes::wire::Matrices, shapes::MatricesSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Matrices& value) {
  return rpc::decodeAs<shapes::wire::Matrices, shapes::MatricesSlot>(bytes, value);
}

template <>
const InterfaceInfo& interfaceInfo<shapes::Store>() {
  static constexpr InterfaceInfo kInfo{
      .name = "shapes::Store",
      .hash = "5839ad6669a078a7c2d8c90f1fd4ac0e",
      .description = shapes::kStoreDescription,
      .commands = shapes::kStoreCommands,
      .events = shapes::kStoreEvents,
      .codec = &shapes::storeCodec,
  };
  return kInfo;
}

auto Provided<shapes::Store>::Scratch::reserved() -> Scratch {
  Scratch scratch;
  reserveFor<decltype(shapes::StorePutArguments::value)>(scratch.put_value);
  return scratch;
}

// A function for each command of shapes::Store, so that a stack in a debugger names it.
struct Provided<shapes::Store>::Dispatch {
  static Errc execute_put(Contract& implementation, Scratch& scratch, const std::byte* arguments) {
    const auto& slot = slotIn<shapes::StorePutArguments>(arguments);
    load(slot.value, scratch.put_value);
    implementation.put(scratch.put_value);
    return Errc{};
  }

  static Errc execute_choose(Contract& implementation, Scratch& scratch,
                             const std::byte* arguments) {
    const auto& slot = slotIn<shapes::StoreChooseArguments>(arguments);
    load(slot.gain, scratch.choose_gain);
    implementation.choose(scratch.choose_gain);
    return Errc{};
  }

  static Errc execute_sequences(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<shapes::SequencesSlot>(result);
    return store(implementation.sequences(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_choices(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<shapes::ChoicesSlot>(result);
    return store(implementation.choices(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_matrices(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<shapes::MatricesSlot>(result);
    return store(implementation.matrices(), slot) ? Errc{} : Errc::TooLarge;
  }

  static Errc execute_reading(Contract& implementation, std::byte* result) {
    auto& slot = newSlot<suture::SlotTuple<double, std::int16_t>>(result);
    return store(implementation.reading(), slot) ? Errc{} : Errc::TooLarge;
  }
};

Errc Provided<shapes::Store>::execute(std::uint16_t command, const std::byte* arguments,
                                      std::byte* result) {
  using ::shapes::StoreCommand;
  switch (static_cast<StoreCommand>(command)) {
    case StoreCommand::put: return Dispatch::execute_put(implementation_, scratch_, arguments);
    case StoreCommand::choose:
      return Dispatch::execute_choose(implementation_, scratch_, arguments);
    case StoreCommand::sequences: return Dispatch::execute_sequences(implementation_, result);
    case StoreCommand::choices: return Dispatch::execute_choices(implementation_, result);
    case StoreCommand::matrices: return Dispatch::execute_matrices(implementation_, result);
    case StoreCommand::reading: return Dispatch::execute_reading(implementation_, result);
  }
  return Errc::Invalid;
}

}  // namespace suture
