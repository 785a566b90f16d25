// Written by suturec from shapes/classes.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "shapes/classes.h"
#include "shapes/containers.suture.h"

namespace suture {

/// Reaches members that SUTURE_FRIEND() opens to generated code.
template <>
struct Members<shapes::Counter> {
  static auto& count_(auto&& value) { return value.count_; }
};

}  // namespace suture

namespace shapes {

struct TreeSlot;

/// A base.
struct NamedSlot {
  suture::BoundedText<8> name;
};

bool store(const Named& value, NamedSlot& slot);
void load(const NamedSlot& slot, Named& value);
void reserve(const NamedSlot*, Named& value);

/// The names of the instances.
struct StampedPointSlot {
  PointSlot value;
  double time;  // s
};

bool store(const StampedPoint& value, StampedPointSlot& slot);
void load(const StampedPointSlot& slot, StampedPoint& value);

/// Two bases, an instance of a template before its alias, and what is no part of the value.
struct ToolSlot {
  NamedSlot base;
  PointSlot basePoint;
  StampedPointSlot last;
};

bool store(const Tool& value, ToolSlot& slot);
void load(const ToolSlot& slot, Tool& value);
void reserve(const ToolSlot*, Tool& value);

struct StampedLevelSlot {
  std::int16_t value;  // Level
  double time;         // s
};

bool store(const StampedLevel& value, StampedLevelSlot& slot);
void load(const StampedLevelSlot& slot, StampedLevel& value);

/// Keeps its members to itself.
struct CounterSlot {
  std::int32_t count_;
};

bool store(const Counter& value, CounterSlot& slot);
void load(const CounterSlot& slot, Counter& value);

/// Holds itself: legal where no slot is needed.
struct TreeSlot {
  std::int32_t value;
  suture::OpenList<TreeSlot> children;
  suture::OpenOptional<TreeSlot> shadow;
};

bool store(const Tree& value, TreeSlot& slot);
void load(const TreeSlot& slot, Tree& value);

/// Everything above that has bounds.
struct ClassesSlot {
  ToolSlot tool;
  StampedLevelSlot level;
  CounterSlot counter;
  PointSlot polar;
  suture::BoundedList<PointSlot, 2> spiral;
};

bool store(const Classes& value, ClassesSlot& slot);
void load(const ClassesSlot& slot, Classes& value);
void reserve(const ClassesSlot*, Classes& value);

bool isValid(const NamedSlot& slot, suture::FieldPath* path);
bool isValid(const StampedPointSlot& slot, suture::FieldPath* path);
bool isValid(const ToolSlot& slot, suture::FieldPath* path);
bool isValid(const StampedLevelSlot& slot, suture::FieldPath* path);
bool isValid(const CounterSlot& slot, suture::FieldPath* path);
bool isValid(const TreeSlot& slot, suture::FieldPath* path);
bool isValid(const ClassesSlot& slot, suture::FieldPath* path);

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Named& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Named& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::StampedPoint& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::StampedPoint& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Tool& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Tool& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::StampedLevel& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::StampedLevel& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Counter& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Counter& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Tree& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Tree& value);

template <>
Result<std::vector<std::byte>> encode(const shapes::Classes& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Classes& value);

}  // namespace suture
