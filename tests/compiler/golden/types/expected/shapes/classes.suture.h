// Written by suturec from shapes/classes.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "shapes/classes.h"
#include "shapes/containers.suture.h"

namespace suture {

/// What SUTURE_FRIEND() lets generated code reach.
template <>
struct Members<shapes::Counter> {
  static auto& count_(auto& value) { return value.count_; }
};

}  // namespace suture

namespace shapes {

/// A base.
struct NamedSlot {
  suture::BoundedText<8> name;
};

inline bool store(const Named& value, NamedSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.name, slot.name);
  return fits;
}

inline void load(const NamedSlot& slot, Named& value) {
  using suture::load;
  load(slot.name, value.name);
}

/// The names of the instances.
struct StampedPointSlot {
  PointSlot value;
  double time;  // s
};

inline bool store(const StampedPoint& value, StampedPointSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.value, slot.value);
  fits &= store(value.time, slot.time);
  return fits;
}

inline void load(const StampedPointSlot& slot, StampedPoint& value) {
  using suture::load;
  load(slot.value, value.value);
  load(slot.time, value.time);
}

/// Two bases, an instance of a template before its alias, and what is no part of the value.
struct ToolSlot {
  NamedSlot base;
  PointSlot basePoint;
  StampedPointSlot last;
};

inline bool store(const Tool& value, ToolSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(static_cast<const Named&>(value), slot.base);
  fits &= store(static_cast<const Point&>(value), slot.basePoint);
  fits &= store(value.last, slot.last);
  return fits;
}

inline void load(const ToolSlot& slot, Tool& value) {
  using suture::load;
  load(slot.base, static_cast<Named&>(value));
  load(slot.basePoint, static_cast<Point&>(value));
  load(slot.last, value.last);
}

struct StampedLevelSlot {
  std::int16_t value;  // Level
  double time;         // s
};

inline bool store(const StampedLevel& value, StampedLevelSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.value, slot.value);
  fits &= store(value.time, slot.time);
  return fits;
}

inline void load(const StampedLevelSlot& slot, StampedLevel& value) {
  using suture::load;
  load(slot.value, value.value);
  load(slot.time, value.time);
}

/// Keeps its members to itself.
struct CounterSlot {
  std::int32_t count_;
};

inline bool store(const Counter& value, CounterSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(suture::Members<Counter>::count_(value), slot.count_);
  return fits;
}

inline void load(const CounterSlot& slot, Counter& value) {
  using suture::load;
  load(slot.count_, suture::Members<Counter>::count_(value));
}

/// Everything above that has bounds.
struct ClassesSlot {
  ToolSlot tool;
  StampedLevelSlot level;
  CounterSlot counter;
  PointSlot polar;
  suture::BoundedList<PointSlot, 2> spiral;
};

inline bool store(const Classes& value, ClassesSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.tool, slot.tool);
  fits &= store(value.level, slot.level);
  fits &= store(value.counter, slot.counter);
  fits &= store(value.polar, slot.polar);
  fits &= store(value.spiral, slot.spiral);
  return fits;
}

inline void load(const ClassesSlot& slot, Classes& value) {
  using suture::load;
  load(slot.tool, value.tool);
  load(slot.level, value.level);
  load(slot.counter, value.counter);
  load(slot.polar, value.polar);
  load(slot.spiral, value.spiral);
}

}  // namespace shapes
