// Written by suturec from shapes/containers.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "shapes/containers.capnp.h"
#include "shapes/containers.suture.h"

namespace shapes {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::Level wireLevel(std::int16_t slot) {
  switch (static_cast<Level>(slot)) {
    case Level::Unknown: return wire::Level::UNKNOWN;
    case Level::Low: return wire::Level::LOW;
    case Level::High: return wire::Level::HIGH;
  }
  return wire::Level{};
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

static void toWire(const suture::SlotEntry<suture::BoundedText<6>, double>& slot,
                   wire::ShapesContainersEntryOfTextToFloat64::Builder out) {
  toWire(slot.key, out.initKey(sizeOf(slot.key)));
  out.setValue(slot.value);
}

static suture::Errc fromWire(wire::ShapesContainersEntryOfTextToFloat64::Reader in,
                             suture::SlotEntry<suture::BoundedText<6>, double>& slot,
                             suture::Duration) {
  slot.value = in.getValue();
  return fromWire(in.getKey(), slot.key);
}

static void toWire(const suture::SlotEntry<std::uint16_t, PointSlot>& slot,
                   wire::ShapesContainersEntryOfUInt16ToPoint::Builder out) {
  out.setKey(slot.key);
  toWire(slot.value, out.initValue());
}

static suture::Errc fromWire(wire::ShapesContainersEntryOfUInt16ToPoint::Reader in,
                             suture::SlotEntry<std::uint16_t, PointSlot>& slot,
                             suture::Duration shift) {
  slot.key = in.getKey();
  return fromWire(in.getValue(), slot.value, shift);
}

static void toWire(const suture::SlotEntry<suture::BoundedText<4>, suture::BoundedList<float, 3>>& slot,
                   wire::ShapesContainersEntryOfTextToListOfFloat32::Builder out) {
  toWire(slot.key, out.initKey(sizeOf(slot.key)));
  toWire(slot.value, out.initValue(sizeOf(slot.value)));
}

static suture::Errc fromWire(wire::ShapesContainersEntryOfTextToListOfFloat32::Reader in,
                             suture::SlotEntry<suture::BoundedText<4>, suture::BoundedList<float, 3>>& slot,
                             suture::Duration) {
  return suture::codec::firstError({
      fromWire(in.getKey(), slot.key),
      fromWire(in.getValue(), slot.value),
  });
}

static void toWire(const suture::SlotEntry<std::int16_t, double>& slot,
                   wire::ShapesContainersEntryOfLevelToFloat64::Builder out) {
  out.setKey(wireLevel(slot.key));
  out.setValue(slot.value);
}

static suture::Errc fromWire(wire::ShapesContainersEntryOfLevelToFloat64::Reader in,
                             suture::SlotEntry<std::int16_t, double>& slot, suture::Duration) {
  slot.value = in.getValue();
  return fromWire(in.getKey(), slot.key);
}

void toWire(const SequencesSlot& slot, wire::Sequences::Builder out) {
  toWire(slot.bytes, out.initBytes(sizeOf(slot.bytes)));
  out.setOne(slot.one);
  toWire(slot.row, out.initRow(3));
  suture::codec::toWireList(slot.grid, out.initGrid(2),
                            [](const std::array<std::int32_t, 3>& element, auto list, std::uint32_t i) {
                              toWire(element, list.init(i, 3));
                            });
  suture::codec::toWireList(slot.corners, out.initCorners(2),
                            [](const PointSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  suture::codec::toWireList(slot.path, out.initPath(sizeOf(slot.path)),
                            [](const PointSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  toWire(slot.bits, out.initBits(sizeOf(slot.bits)));
  toWire(slot.flags, out.initFlags(sizeOf(slot.flags)));
  toWire(slot.numbers, out.initNumbers(sizeOf(slot.numbers)));
  toWire(slot.words, out.initWords(sizeOf(slot.words)));
  suture::codec::toWireList(slot.levels, out.initLevels(sizeOf(slot.levels)),
                            [](const std::int16_t& element, auto list, std::uint32_t i) {
                              list.set(i, wireLevel(element));
                            });
  suture::codec::toWireList(slot.gains, out.initGains(sizeOf(slot.gains)),
                            [](const auto& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  suture::codec::toWireList(slot.points, out.initPoints(sizeOf(slot.points)),
                            [](const auto& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  suture::codec::toWireList(slot.series, out.initSeries(sizeOf(slot.series)),
                            [](const auto& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  suture::codec::toWireList(slot.shares, out.initShares(sizeOf(slot.shares)),
                            [](const auto& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
}

suture::Errc fromWire(wire::Sequences::Reader in, SequencesSlot& slot, suture::Duration shift) {
  slot.one = in.getOne();
  return suture::codec::firstError({
      fromWire(in.getBytes(), slot.bytes),
      fromWire(in.getRow(), slot.row),
      suture::codec::fromWireList(in.getGrid(), slot.grid,
                                  [](auto item, std::array<std::int32_t, 3>& target) {
                                    return fromWire(item, target);
                                  }),
      suture::codec::fromWireList(in.getCorners(), slot.corners, [&](auto item, PointSlot& target) {
        return fromWire(item, target, shift);
      }),
      suture::codec::fromWireList(in.getPath(), slot.path, [&](auto item, PointSlot& target) {
        return fromWire(item, target, shift);
      }),
      fromWire(in.getBits(), slot.bits),
      fromWire(in.getFlags(), slot.flags),
      suture::codec::fromWireDistinct(in.getNumbers(), slot.numbers,
                                      [](auto item, std::int32_t& target) {
                                        return target = item, suture::Errc{};
                                      }),
      suture::codec::fromWireDistinct(in.getWords(), slot.words,
                                      [](auto item, suture::BoundedText<6>& target) {
                                        return fromWire(item, target);
                                      }),
      suture::codec::fromWireDistinct(in.getLevels(), slot.levels,
                                      [](auto item, std::int16_t& target) {
                                        return fromWire(item, target);
                                      }),
      suture::codec::fromWireDistinct(in.getGains(), slot.gains, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
      suture::codec::fromWireDistinct(in.getPoints(), slot.points, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
      suture::codec::fromWireDistinct(in.getSeries(), slot.series, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
      suture::codec::fromWireDistinct(in.getShares(), slot.shares, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
  });
}

static void toWire(const suture::SlotOptional<double>& slot,
                   wire::ShapesContainersOptionalFloat64::Builder out) {
  if (slot.present == 0) return out.setNone();
  out.setSome(slot.value);
}

static suture::Errc fromWire(wire::ShapesContainersOptionalFloat64::Reader in,
                             suture::SlotOptional<double>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  slot.value = in.getSome();
  return suture::Errc{};
}

static void toWire(const suture::SlotOptional<std::uint8_t>& slot,
                   wire::ShapesContainersOptionalBool::Builder out) {
  if (slot.present == 0) return out.setNone();
  out.setSome(slot.value != 0);
}

static suture::Errc fromWire(wire::ShapesContainersOptionalBool::Reader in,
                             suture::SlotOptional<std::uint8_t>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  slot.value = in.getSome();
  return suture::Errc{};
}

static void toWire(const suture::SlotOptional<suture::BoundedText<8>>& slot,
                   wire::ShapesContainersOptionalText::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome(sizeOf(slot.value)));
}

static suture::Errc fromWire(wire::ShapesContainersOptionalText::Reader in,
                             suture::SlotOptional<suture::BoundedText<8>>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value);
}

static void toWire(const suture::SlotOptional<PointSlot>& slot,
                   wire::ShapesContainersOptionalPoint::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome());
}

static suture::Errc fromWire(wire::ShapesContainersOptionalPoint::Reader in,
                             suture::SlotOptional<PointSlot>& slot, suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value, shift);
}

static void toWire(const suture::SlotOptional<suture::BoundedList<PointSlot, 2>>& slot,
                   wire::ShapesContainersOptionalListOfPoint::Builder out) {
  if (slot.present == 0) return out.setNone();
  suture::codec::toWireList(slot.value, out.initSome(sizeOf(slot.value)),
                            [](const PointSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
}

static suture::Errc fromWire(wire::ShapesContainersOptionalListOfPoint::Reader in,
                             suture::SlotOptional<suture::BoundedList<PointSlot, 2>>& slot,
                             suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return suture::codec::fromWireList(in.getSome(), slot.value, [&](auto item, PointSlot& target) {
    return fromWire(item, target, shift);
  });
}

static void toWire(const suture::SlotOptional<std::int32_t>& slot,
                   wire::ShapesContainersOptionalInt32::Builder out) {
  if (slot.present == 0) return out.setNone();
  out.setSome(slot.value);
}

static suture::Errc fromWire(wire::ShapesContainersOptionalInt32::Reader in,
                             suture::SlotOptional<std::int32_t>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  slot.value = in.getSome();
  return suture::Errc{};
}

static void toWire(const suture::SlotOptional<suture::SlotOptional<std::int32_t>>& slot,
                   wire::ShapesContainersOptionalOptionalInt32::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome());
}

static suture::Errc fromWire(wire::ShapesContainersOptionalOptionalInt32::Reader in,
                             suture::SlotOptional<suture::SlotOptional<std::int32_t>>& slot,
                             suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value, shift);
}

static void toWire(const suture::SlotOptional<std::array<double, 3>>& slot,
                   wire::ShapesContainersOptionalVec3::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome());
}

static suture::Errc fromWire(wire::ShapesContainersOptionalVec3::Reader in,
                             suture::SlotOptional<std::array<double, 3>>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value);
}

static void toWire(const suture::SlotTuple<std::int32_t, double>& slot,
                   wire::ShapesContainersTupleOfInt32AndFloat64::Builder out) {
  out.setItem0(suture::item<0>(slot));
  out.setItem1(suture::item<1>(slot));
}

static suture::Errc fromWire(wire::ShapesContainersTupleOfInt32AndFloat64::Reader in,
                             suture::SlotTuple<std::int32_t, double>& slot, suture::Duration) {
  suture::item<0>(slot) = in.getItem0();
  suture::item<1>(slot) = in.getItem1();
  return suture::Errc{};
}

static void toWire(const suture::SlotTuple<std::uint8_t, suture::BoundedText<4>, PointSlot>& slot,
                   wire::ShapesContainersTupleOfBoolAndTextAndPoint::Builder out) {
  out.setItem0(suture::item<0>(slot) != 0);
  toWire(suture::item<1>(slot), out.initItem1(sizeOf(suture::item<1>(slot))));
  toWire(suture::item<2>(slot), out.initItem2());
}

static suture::Errc fromWire(wire::ShapesContainersTupleOfBoolAndTextAndPoint::Reader in,
                             suture::SlotTuple<std::uint8_t, suture::BoundedText<4>, PointSlot>& slot,
                             suture::Duration shift) {
  suture::item<0>(slot) = in.getItem0();
  return suture::codec::firstError({
      fromWire(in.getItem1(), suture::item<1>(slot)),
      fromWire(in.getItem2(), suture::item<2>(slot), shift),
  });
}

static void toWire(const suture::SlotVariant<suture::SlotNothing, double, PointSlot, suture::BoundedText<4>, double>& slot,
                   wire::ShapesContainersEitherOfNothingOrFloat64OrPointOrTextOrFloat64::Builder out) {
  if (slot.index == 0) return out.setNothing();
  if (slot.index == 1) return out.setFloat64(suture::alternative<1>(slot));
  if (slot.index == 2) return toWire(suture::alternative<2>(slot), out.initPoint());
  if (slot.index == 3) return toWire(suture::alternative<3>(slot),
                                     out.initText(sizeOf(suture::alternative<3>(slot))));
  if (slot.index == 4) return out.setFloat64At4(suture::alternative<4>(slot));
}

static suture::Errc fromWire(wire::ShapesContainersEitherOfNothingOrFloat64OrPointOrTextOrFloat64::Reader in,
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

static void toWire(const suture::SlotVariant<std::int16_t, suture::SlotOptional<PointSlot>>& slot,
                   wire::ShapesContainersEitherOfLevelOrOptionalPoint::Builder out) {
  if (slot.index == 0) return out.setLevel(wireLevel(suture::alternative<0>(slot)));
  if (slot.index == 1) return toWire(suture::alternative<1>(slot), out.initOptionalPoint());
}

static suture::Errc fromWire(wire::ShapesContainersEitherOfLevelOrOptionalPoint::Reader in,
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

static void toWire(const suture::SlotTuple<double, std::int16_t>& slot,
                   wire::ShapesContainersTupleOfFloat64AndLevel::Builder out) {
  out.setItem0(suture::item<0>(slot));
  out.setItem1(wireLevel(suture::item<1>(slot)));
}

static suture::Errc fromWire(wire::ShapesContainersTupleOfFloat64AndLevel::Reader in,
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
  suture::codec::toWireList(slot.seen, out.initSeen(sizeOf(slot.seen)),
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
  return suture::codec::firstError({
      fromWire(in.getGain(), slot.gain, shift),
      fromWire(in.getShare(), slot.share, shift),
      fromWire(in.getAnswer(), slot.answer, shift),
      fromWire(in.getFrame(), slot.frame, shift),
      fromWire(in.getTarget(), slot.target, shift),
      fromWire(in.getPolygon(), slot.polygon, shift),
      fromWire(in.getTwice(), slot.twice, shift),
      suture::codec::fromWireList(in.getSeen(), slot.seen, [&](auto item, auto& target) {
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

void toWire(const MatricesSlot& slot, wire::Matrices::Builder out) {
  toWire(slot.joints, out.initJoints(sizeOf(slot.joints)));
  toWire(slot.row, out.initRow(sizeOf(slot.row)));
  toWire(slot.any, out.initAny());
  toWire(slot.counts, out.initCounts());
  suture::codec::toWireFlat(slot.columns, out.initColumns(sizeOf(slot.columns) * 3));
  toWire(slot.limited, out.initLimited(sizeOf(slot.limited)));
  toWire(slot.fixed, out.initFixed(20));
  suture::codec::toWireFlat(slot.cloud, out.initCloud(sizeOf(slot.cloud) * 3));
  suture::codec::toWireFlat(slot.wrenches, out.initWrenches(sizeOf(slot.wrenches) * 6));
  toWire(slot.scaled, out.initScaled());
  out.setWait(slot.wait);
}

suture::Errc fromWire(wire::Matrices::Reader in, MatricesSlot& slot, suture::Duration) {
  slot.wait = in.getWait();
  return suture::codec::firstError({
      fromWire(in.getJoints(), slot.joints),
      fromWire(in.getRow(), slot.row),
      fromWire(in.getAny(), slot.any),
      fromWire(in.getCounts(), slot.counts),
      suture::codec::fromWireFlat(in.getColumns(), slot.columns),
      fromWire(in.getLimited(), slot.limited),
      in.getFixed().size() != 0 ? fromWire(in.getFixed(), slot.fixed)
          : suture::codec::fromDefault(Matrices().fixed, slot.fixed),
      suture::codec::fromWireFlat(in.getCloud(), slot.cloud),
      suture::codec::fromWireFlat(in.getWrenches(), slot.wrenches),
      in.hasScaled() ? suture::codec::fromWireAffine(in.getScaled(), slot.scaled)
          : suture::codec::fromDefault(Matrices().scaled, slot.scaled),
  });
}

static void toWire(const suture::SlotVariant<double, PointSlot>& slot,
                   wire::ShapesContainersEitherOfFloat64OrPoint::Builder out) {
  if (slot.index == 0) return out.setFloat64(suture::alternative<0>(slot));
  if (slot.index == 1) return toWire(suture::alternative<1>(slot), out.initPoint());
}

static suture::Errc fromWire(wire::ShapesContainersEitherOfFloat64OrPoint::Reader in,
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

// --- Store as Cap'n Proto

namespace {

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
  switch (column) {
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
  switch (column) {
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

constexpr suture::codec::CommandCodec kStoreCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Store>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Store::PutParams>,
     .arguments = suture::codec::messageOf<wire::Store::PutParams, StorePutArguments,
                                           encodeStorePut, decodeStorePut>},
    {.interface = capnp::typeId<wire::Store>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Store::ChooseParams>,
     .arguments = suture::codec::messageOf<wire::Store::ChooseParams, StoreChooseArguments,
                                           encodeStoreChoose, decodeStoreChoose>},
    {.interface = capnp::typeId<wire::Store>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Store::SequencesParams>,
     .result = suture::codec::messageOf<wire::Store::SequencesResults, SequencesSlot,
                                        encodeStoreSequencesResult, decodeStoreSequencesResult>,
     .stamp = suture::codec::stampIn<wire::Store::SequencesResults>},
    {.interface = capnp::typeId<wire::Store>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Store::ChoicesParams>,
     .result = suture::codec::messageOf<wire::Store::ChoicesResults, ChoicesSlot,
                                        encodeStoreChoicesResult, decodeStoreChoicesResult>,
     .stamp = suture::codec::stampIn<wire::Store::ChoicesResults>},
    {.interface = capnp::typeId<wire::Store>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::Store::MatricesParams>,
     .result = suture::codec::messageOf<wire::Store::MatricesResults, MatricesSlot,
                                        encodeStoreMatricesResult, decodeStoreMatricesResult>,
     .stamp = suture::codec::stampIn<wire::Store::MatricesResults>},
    {.interface = capnp::typeId<wire::Store>(),
     .method = 6,
     .sent = suture::codec::sentIn<wire::Store::ReadingParams>,
     .result = suture::codec::messageOf<wire::Store::ReadingResults,
                                        suture::SlotTuple<double, std::int16_t>,
                                        encodeStoreReadingResult, decodeStoreReadingResult>,
     .stamp = suture::codec::stampIn<wire::Store::ReadingResults>},
};

constexpr suture::codec::EventCodec kStoreEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::StoreEvents::ChangedParams>,
     .payload = suture::codec::messageOf<wire::StoreEvents::ChangedParams,
                                         suture::SlotVariant<double, PointSlot>,
                                         encodeStoreChangedEvent, decodeStoreChangedEvent>},
};

}  // namespace

const suture::codec::Codec& storeCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Store>,
      .contract = capnp::typeId<wire::Store>(),
      .subscriber = capnp::typeId<wire::StoreEvents>(),
      .commands = kStoreCommandCodecs,
      .events = kStoreEventCodecs,
      .row = suture::codec::rowOf<wire::StoreEvents::StateParams, wire::StoreStateRow,
                                  encodeStoreColumn, decodeStoreColumn>,
  };
  return kCodec;
}

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Point& value) {
  return codec::encodeAs<shapes::wire::Point, shapes::PointSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Point& value) {
  return codec::decodeAs<shapes::wire::Point, shapes::PointSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Sequences& value) {
  return codec::encodeAs<shapes::wire::Sequences, shapes::SequencesSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Sequences& value) {
  return codec::decodeAs<shapes::wire::Sequences, shapes::SequencesSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Choices& value) {
  return codec::encodeAs<shapes::wire::Choices, shapes::ChoicesSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Choices& value) {
  return codec::decodeAs<shapes::wire::Choices, shapes::ChoicesSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Matrices& value) {
  return codec::encodeAs<shapes::wire::Matrices, shapes::MatricesSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Matrices& value) {
  return codec::decodeAs<shapes::wire::Matrices, shapes::MatricesSlot>(bytes, value);
}

}  // namespace suture
