#pragma once
// These classes are more than plain structs: derived, templates, private, opaque, recursive.

#include <suture/annotate.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "shapes/containers.h"

namespace shapes {

/// Where and when.
template <class T>
struct SUTURE_TYPE() Stamped {
  T value{};
  SUTURE_FIELD(unit("s")) double time = 0;
};

/// A base.
struct SUTURE_TYPE() Named {
  SUTURE_FIELD(capacity(8)) std::string name;
};

/// Two bases, an instance of a template before its alias, and what is no part of the value.
struct SUTURE_TYPE() Tool : Named, Point {
  Stamped<Point> last;
  SUTURE_FIELD(skip()) mutable std::mutex guard;
  SUTURE_FIELD(skip()) const Tool* previous = nullptr;
};

/// The names of the instances.
using StampedPoint = Stamped<Point>;
using StampedLevel = Stamped<Level>;

/// Keeps its members to itself.
class SUTURE_TYPE() Counter {
 public:
  Counter() = default;
  explicit Counter(std::int32_t count) : count_(count) {}
  std::int32_t count() const { return count_; }

 private:
  SUTURE_FRIEND()

  SUTURE_FIELD(range(0, 100)) std::int32_t count_ = 0;
};

/// Cannot be looked into; travels as a Point.
class Polar {
 public:
  Polar() = default;
  Polar(double radius, double angle) : radius_(radius), angle_(angle) {}
  double radius() const { return radius_; }
  double angle() const { return angle_; }

 private:
  double radius_ = 0, angle_ = 0;
};

/// Holds itself: legal where no slot is needed.
struct SUTURE_TYPE() Tree {
  std::int32_t value = 0;
  std::vector<Tree> children;
  std::unique_ptr<Tree> shadow;
};

}  // namespace shapes

template <>
struct suture::Wire<shapes::Polar> {
  using Type = shapes::Point;
  static Type to(const shapes::Polar& value);
  static shapes::Polar from(const Type& form);
};

namespace shapes {

/// Everything above that has bounds.
struct SUTURE_TYPE() Classes {
  Tool tool;
  StampedLevel level;
  Counter counter;
  Polar polar;
  SUTURE_FIELD(capacity(2)) std::vector<Polar> spiral;
};

}  // namespace shapes
