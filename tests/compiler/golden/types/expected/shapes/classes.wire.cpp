// Written by suturec from shapes/classes.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "shapes/classes.capnp.h"
#include "shapes/classes.suture.h"

// Defined in shapes/containers.wire.cpp.
namespace shapes {
wire::Level wireLevel(std::int16_t slot);
suture::Errc fromWire(wire::Level in, std::int16_t& slot);
void toWire(const PointSlot& slot, wire::Point::Builder out);
suture::Errc fromWire(wire::Point::Reader in, PointSlot& slot, suture::Duration shift);
}  // namespace shapes

namespace shapes {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const TreeSlot& slot, wire::Tree::Builder out);
suture::Errc fromWire(wire::Tree::Reader in, TreeSlot& slot, suture::Duration shift);

void toWire(const NamedSlot& slot, wire::Named::Builder out) {
  toWire(slot.name, out.initName(sizeOf(slot.name)));
}

suture::Errc fromWire(wire::Named::Reader in, NamedSlot& slot, suture::Duration) {
  return fromWire(in.getName(), slot.name);
}

void toWire(const StampedPointSlot& slot, wire::StampedPoint::Builder out) {
  toWire(slot.value, out.initValue());
  out.setTime(slot.time);
}

suture::Errc fromWire(wire::StampedPoint::Reader in, StampedPointSlot& slot,
                      suture::Duration shift) {
  slot.time = in.getTime();
  return fromWire(in.getValue(), slot.value, shift);
}

void toWire(const ToolSlot& slot, wire::Tool::Builder out) {
  toWire(slot.base, out.initBase());
  toWire(slot.basePoint, out.initBasePoint());
  toWire(slot.last, out.initLast());
}

suture::Errc fromWire(wire::Tool::Reader in, ToolSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getBase(), slot.base, shift),
      fromWire(in.getBasePoint(), slot.basePoint, shift),
      fromWire(in.getLast(), slot.last, shift),
  });
}

void toWire(const StampedLevelSlot& slot, wire::StampedLevel::Builder out) {
  out.setValue(wireLevel(slot.value));
  out.setTime(slot.time);
}

suture::Errc fromWire(wire::StampedLevel::Reader in, StampedLevelSlot& slot, suture::Duration) {
  slot.time = in.getTime();
  return fromWire(in.getValue(), slot.value);
}

void toWire(const CounterSlot& slot, wire::Counter::Builder out) {
  out.setCount(slot.count_);
}

suture::Errc fromWire(wire::Counter::Reader in, CounterSlot& slot, suture::Duration) {
  slot.count_ = in.getCount();
  return suture::Errc{};
}

static void toWire(const suture::OpenOptional<TreeSlot>& slot,
                   wire::ShapesClassesOptionalTree::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(*slot.value, out.initSome());
}

static suture::Errc fromWire(wire::ShapesClassesOptionalTree::Reader in,
                             suture::OpenOptional<TreeSlot>& slot, suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  engage(slot);
  return fromWire(in.getSome(), *slot.value, shift);
}

void toWire(const TreeSlot& slot, wire::Tree::Builder out) {
  out.setValue(slot.value);
  suture::codec::toWireList(slot.children, out.initChildren(sizeOf(slot.children)),
                            [](const TreeSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  toWire(slot.shadow, out.initShadow());
}

suture::Errc fromWire(wire::Tree::Reader in, TreeSlot& slot, suture::Duration shift) {
  slot.value = in.getValue();
  return suture::codec::firstError({
      suture::codec::fromWireList(in.getChildren(), slot.children,
                                  [&](auto item, TreeSlot& target) {
                                    return fromWire(item, target, shift);
                                  }),
      fromWire(in.getShadow(), slot.shadow, shift),
  });
}

void toWire(const ClassesSlot& slot, wire::Classes::Builder out) {
  toWire(slot.tool, out.initTool());
  toWire(slot.level, out.initLevel());
  toWire(slot.counter, out.initCounter());
  toWire(slot.polar, out.initPolar());
  suture::codec::toWireList(slot.spiral, out.initSpiral(sizeOf(slot.spiral)),
                            [](const PointSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
}

suture::Errc fromWire(wire::Classes::Reader in, ClassesSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getTool(), slot.tool, shift),
      fromWire(in.getLevel(), slot.level, shift),
      fromWire(in.getCounter(), slot.counter, shift),
      fromWire(in.getPolar(), slot.polar, shift),
      suture::codec::fromWireList(in.getSpiral(), slot.spiral, [&](auto item, PointSlot& target) {
        return fromWire(item, target, shift);
      }),
  });
}

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Named& value) {
  return codec::encodeAs<shapes::wire::Named, shapes::NamedSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Named& value) {
  return codec::decodeAs<shapes::wire::Named, shapes::NamedSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::StampedPoint& value) {
  return codec::encodeAs<shapes::wire::StampedPoint, shapes::StampedPointSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::StampedPoint& value) {
  return codec::decodeAs<shapes::wire::StampedPoint, shapes::StampedPointSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Tool& value) {
  return codec::encodeAs<shapes::wire::Tool, shapes::ToolSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Tool& value) {
  return codec::decodeAs<shapes::wire::Tool, shapes::ToolSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::StampedLevel& value) {
  return codec::encodeAs<shapes::wire::StampedLevel, shapes::StampedLevelSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::StampedLevel& value) {
  return codec::decodeAs<shapes::wire::StampedLevel, shapes::StampedLevelSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Counter& value) {
  return codec::encodeAs<shapes::wire::Counter, shapes::CounterSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Counter& value) {
  return codec::decodeAs<shapes::wire::Counter, shapes::CounterSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Tree& value) {
  return codec::encodeAs<shapes::wire::Tree, shapes::TreeSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Tree& value) {
  return codec::decodeAs<shapes::wire::Tree, shapes::TreeSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Classes& value) {
  return codec::encodeAs<shapes::wire::Classes, shapes::ClassesSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Classes& value) {
  return codec::decodeAs<shapes::wire::Classes, shapes::ClassesSlot>(bytes, value);
}

}  // namespace suture
