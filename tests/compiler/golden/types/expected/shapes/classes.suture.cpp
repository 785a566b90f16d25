// Written by suturec from shapes/classes.h. Do not edit.
#include "shapes/classes.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "shapes/classes.capnp.h"

// Defined in shapes/containers.suture.cpp.
namespace shapes {
wire::Level wireLevel(std::int16_t slot);
bool isKnownLevel(std::int16_t slot);
suture::Errc fromWire(wire::Level in, std::int16_t& slot);
void toWire(const PointSlot& slot, wire::Point::Builder out);
suture::Errc fromWire(wire::Point::Reader in, PointSlot& slot, suture::Duration shift);
bool isValid(const PointSlot& slot, suture::FieldPath* path);
}  // namespace shapes

namespace shapes {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(Named::name), std::string>);
static_assert(std::is_same_v<decltype(StampedPoint::value), Point>);
static_assert(std::is_same_v<decltype(StampedPoint::time), double>);
static_assert(std::is_base_of_v<Named, Tool>);
static_assert(std::is_base_of_v<Point, Tool>);
static_assert(std::is_same_v<decltype(Tool::last), StampedPoint>);
static_assert(std::is_same_v<decltype(StampedLevel::value), Level>);
static_assert(std::is_same_v<decltype(StampedLevel::time), double>);
static_assert(std::is_same_v<decltype(suture::Members<Counter>::count_(std::declval<Counter&>())),
                             std::int32_t&>);
static_assert(std::is_same_v<decltype(Tree::value), std::int32_t>);
static_assert(std::is_same_v<decltype(Tree::children), std::vector<shapes::Tree>>);
static_assert(std::is_same_v<decltype(Tree::shadow), std::unique_ptr<shapes::Tree>>);
static_assert(std::is_same_v<decltype(Classes::tool), Tool>);
static_assert(std::is_same_v<decltype(Classes::level), StampedLevel>);
static_assert(std::is_same_v<decltype(Classes::counter), Counter>);
static_assert(std::is_same_v<decltype(Classes::polar), Polar>);
static_assert(std::is_same_v<decltype(Classes::spiral), std::vector<shapes::Polar>>);

}  // namespace

bool store(const Named& value, NamedSlot& slot) {
  bool fits = true;
  fits &= store(value.name, slot.name);
  return fits;
}

void load(const NamedSlot& slot, Named& value) {
  load(slot.name, value.name);
}

void reserve(const NamedSlot*, Named& value) {
  suture::reserveFor<decltype(NamedSlot::name)>(value.name);
}

bool store(const StampedPoint& value, StampedPointSlot& slot) {
  bool fits = true;
  fits &= store(value.value, slot.value);
  fits &= store(value.time, slot.time);
  return fits;
}

void load(const StampedPointSlot& slot, StampedPoint& value) {
  load(slot.value, value.value);
  load(slot.time, value.time);
}

bool store(const Tool& value, ToolSlot& slot) {
  bool fits = true;
  fits &= store(static_cast<const Named&>(value), slot.base);
  fits &= store(static_cast<const Point&>(value), slot.basePoint);
  fits &= store(value.last, slot.last);
  return fits;
}

void load(const ToolSlot& slot, Tool& value) {
  load(slot.base, static_cast<Named&>(value));
  load(slot.basePoint, static_cast<Point&>(value));
  load(slot.last, value.last);
}

void reserve(const ToolSlot*, Tool& value) {
  suture::reserveFor<decltype(ToolSlot::base)>(static_cast<Named&>(value));
}

bool store(const StampedLevel& value, StampedLevelSlot& slot) {
  bool fits = true;
  fits &= store(value.value, slot.value);
  fits &= store(value.time, slot.time);
  return fits;
}

void load(const StampedLevelSlot& slot, StampedLevel& value) {
  load(slot.value, value.value);
  load(slot.time, value.time);
}

bool store(const Counter& value, CounterSlot& slot) {
  bool fits = true;
  fits &= store(suture::Members<Counter>::count_(value), slot.count_);
  return fits;
}

void load(const CounterSlot& slot, Counter& value) {
  load(slot.count_, suture::Members<Counter>::count_(value));
}

bool store(const Tree& value, TreeSlot& slot) {
  bool fits = true;
  fits &= store(value.value, slot.value);
  fits &= store(value.children, slot.children);
  fits &= store(value.shadow, slot.shadow);
  return fits;
}

void load(const TreeSlot& slot, Tree& value) {
  load(slot.value, value.value);
  load(slot.children, value.children);
  load(slot.shadow, value.shadow);
}

bool store(const Classes& value, ClassesSlot& slot) {
  bool fits = true;
  fits &= store(value.tool, slot.tool);
  fits &= store(value.level, slot.level);
  fits &= store(value.counter, slot.counter);
  fits &= store(value.polar, slot.polar);
  fits &= store(value.spiral, slot.spiral);
  return fits;
}

void load(const ClassesSlot& slot, Classes& value) {
  load(slot.tool, value.tool);
  load(slot.level, value.level);
  load(slot.counter, value.counter);
  load(slot.polar, value.polar);
  load(slot.spiral, value.spiral);
}

void reserve(const ClassesSlot*, Classes& value) {
  suture::reserveFor<decltype(ClassesSlot::tool)>(value.tool);
  suture::reserveFor<decltype(ClassesSlot::spiral)>(value.spiral);
}

// --- between slots and Cap'n Proto

void toWire(const TreeSlot& slot, wire::Tree::Builder out);
suture::Errc fromWire(wire::Tree::Reader in, TreeSlot& slot, suture::Duration shift);
bool isValid(const TreeSlot& slot, suture::FieldPath* path);

void toWire(const NamedSlot& slot, wire::Named::Builder out) {
  toWire(slot.name, out.initName(sizeOf(slot.name)));
}

suture::Errc fromWire(wire::Named::Reader in, NamedSlot& slot, suture::Duration) {
  return fromWire(in.getName(), slot.name);
}

bool isValid(const NamedSlot&, suture::FieldPath*) {
  return true;
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

bool isValid(const StampedPointSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.value, path)) return suture::refusedAt(path, "value");
  return isValid(slot.time) || suture::refusedAt(path, "time");
}

void toWire(const ToolSlot& slot, wire::Tool::Builder out) {
  toWire(slot.base, out.initBase());
  toWire(slot.basePoint, out.initBasePoint());
  toWire(slot.last, out.initLast());
}

suture::Errc fromWire(wire::Tool::Reader in, ToolSlot& slot, suture::Duration shift) {
  return suture::rpc::firstError({
      fromWire(in.getBase(), slot.base, shift),
      fromWire(in.getBasePoint(), slot.basePoint, shift),
      fromWire(in.getLast(), slot.last, shift),
  });
}

bool isValid(const ToolSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.base, path)) return false;
  if (!isValid(slot.basePoint, path)) return false;
  return isValid(slot.last, path) || suture::refusedAt(path, "last");
}

void toWire(const StampedLevelSlot& slot, wire::StampedLevel::Builder out) {
  out.setValue(wireLevel(slot.value));
  out.setTime(slot.time);
}

suture::Errc fromWire(wire::StampedLevel::Reader in, StampedLevelSlot& slot, suture::Duration) {
  slot.time = in.getTime();
  return fromWire(in.getValue(), slot.value);
}

bool isValid(const StampedLevelSlot& slot, suture::FieldPath* path) {
  if (!isKnownLevel(slot.value)) return suture::refusedAt(path, "value");
  return isValid(slot.time) || suture::refusedAt(path, "time");
}

void toWire(const CounterSlot& slot, wire::Counter::Builder out) {
  out.setCount(slot.count_);
}

suture::Errc fromWire(wire::Counter::Reader in, CounterSlot& slot, suture::Duration) {
  slot.count_ = in.getCount();
  return suture::Errc{};
}

bool isValid(const CounterSlot& slot, suture::FieldPath* path) {
  return suture::rpc::inRange(slot.count_, 0, 100) || suture::refusedAt(path, "count_");
}

void toWire(const suture::OpenOptional<TreeSlot>& slot,
            wire::ShapesClassesOptionalTree::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(*slot.value, out.initSome());
}

suture::Errc fromWire(wire::ShapesClassesOptionalTree::Reader in,
                      suture::OpenOptional<TreeSlot>& slot, suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  engage(slot);
  return fromWire(in.getSome(), *slot.value, shift);
}

void toWire(const TreeSlot& slot, wire::Tree::Builder out) {
  out.setValue(slot.value);
  suture::rpc::toWireList(slot.children, out.initChildren(sizeOf(slot.children)),
                          [](const TreeSlot& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
  toWire(slot.shadow, out.initShadow());
}

suture::Errc fromWire(wire::Tree::Reader in, TreeSlot& slot, suture::Duration shift) {
  slot.value = in.getValue();
  return suture::rpc::firstError({
      suture::rpc::fromWireList(in.getChildren(), slot.children, [&](auto item, TreeSlot& target) {
        return fromWire(item, target, shift);
      }),
      fromWire(in.getShadow(), slot.shadow, shift),
  });
}

bool isValid(const TreeSlot& slot, suture::FieldPath* path) {
  if (!suture::rpc::allOf(slot.children, path, [path](const TreeSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "children");
  }
  return isValid(slot.shadow, path) || suture::refusedAt(path, "shadow");
}

void toWire(const ClassesSlot& slot, wire::Classes::Builder out) {
  toWire(slot.tool, out.initTool());
  toWire(slot.level, out.initLevel());
  toWire(slot.counter, out.initCounter());
  toWire(slot.polar, out.initPolar());
  suture::rpc::toWireList(slot.spiral, out.initSpiral(sizeOf(slot.spiral)),
                          [](const PointSlot& element, auto list, std::uint32_t i) {
                            toWire(element, list[i]);
                          });
}

suture::Errc fromWire(wire::Classes::Reader in, ClassesSlot& slot, suture::Duration shift) {
  return suture::rpc::firstError({
      fromWire(in.getTool(), slot.tool, shift),
      fromWire(in.getLevel(), slot.level, shift),
      fromWire(in.getCounter(), slot.counter, shift),
      fromWire(in.getPolar(), slot.polar, shift),
      suture::rpc::fromWireList(in.getSpiral(), slot.spiral, [&](auto item, PointSlot& target) {
        return fromWire(item, target, shift);
      }),
  });
}

bool isValid(const ClassesSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.tool, path)) return suture::refusedAt(path, "tool");
  if (!isValid(slot.level, path)) return suture::refusedAt(path, "level");
  if (!isValid(slot.counter, path)) return suture::refusedAt(path, "counter");
  if (!isValid(slot.polar, path)) return suture::refusedAt(path, "polar");
  if (!suture::rpc::allOf(slot.spiral, path, [path](const PointSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "spiral");
  }
  return true;
}

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Named& value) {
  return rpc::encodeAs<shapes::wire::Named, shapes::NamedSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Named& value) {
  return rpc::decodeAs<shapes::wire::Named, shapes::NamedSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::StampedPoint& value) {
  return rpc::encodeAs<shapes::wire::StampedPoint, shapes::StampedPointSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::StampedPoint& value) {
  return rpc::decodeAs<shapes::wire::StampedPoint, shapes::StampedPointSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Tool& value) {
  return rpc::encodeAs<shapes::wire::Tool, shapes::ToolSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Tool& value) {
  return rpc::decodeAs<shapes::wire::Tool, shapes::ToolSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::StampedLevel& value) {
  return rpc::encodeAs<shapes::wire::StampedLevel, shapes::StampedLevelSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::StampedLevel& value) {
  return rpc::decodeAs<shapes::wire::StampedLevel, shapes::StampedLevelSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Counter& value) {
  return rpc::encodeAs<shapes::wire::Counter, shapes::CounterSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Counter& value) {
  return rpc::decodeAs<shapes::wire::Counter, shapes::CounterSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Tree& value) {
  return rpc::encodeAs<shapes::wire::Tree, shapes::TreeSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Tree& value) {
  return rpc::decodeAs<shapes::wire::Tree, shapes::TreeSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Classes& value) {
  return rpc::encodeAs<shapes::wire::Classes, shapes::ClassesSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Classes& value) {
  return rpc::decodeAs<shapes::wire::Classes, shapes::ClassesSlot>(bytes, value);
}

}  // namespace suture
