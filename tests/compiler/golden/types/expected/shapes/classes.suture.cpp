// Written by suturec from shapes/classes.h. Do not edit.
#include "shapes/classes.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace shapes {

using suture::isValid;
using suture::load;
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

bool isValid(const NamedSlot&, suture::FieldPath*) {
  return true;
}

bool isValid(const StampedPointSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.value, path)) return suture::refusedAt(path, "value");
  return isValid(slot.time) || suture::refusedAt(path, "time");
}

bool isValid(const ToolSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.base, path)) return false;
  if (!isValid(slot.basePoint, path)) return false;
  return isValid(slot.last, path) || suture::refusedAt(path, "last");
}

bool isValid(const StampedLevelSlot& slot, suture::FieldPath* path) {
  if (!isKnownLevel(slot.value)) return suture::refusedAt(path, "value");
  return isValid(slot.time) || suture::refusedAt(path, "time");
}

bool isValid(const CounterSlot& slot, suture::FieldPath* path) {
  return suture::inRange(slot.count_, 0, 100) || suture::refusedAt(path, "count_");
}

bool isValid(const TreeSlot& slot, suture::FieldPath* path) {
  if (!suture::allOf(slot.children, path, [path](const TreeSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "children");
  }
  return isValid(slot.shadow, path) || suture::refusedAt(path, "shadow");
}

bool isValid(const ClassesSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.tool, path)) return suture::refusedAt(path, "tool");
  if (!isValid(slot.level, path)) return suture::refusedAt(path, "level");
  if (!isValid(slot.counter, path)) return suture::refusedAt(path, "counter");
  if (!isValid(slot.polar, path)) return suture::refusedAt(path, "polar");
  if (!suture::allOf(slot.spiral, path, [path](const PointSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "spiral");
  }
  return true;
}

}  // namespace shapes
