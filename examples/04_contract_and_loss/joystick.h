#pragma once
// This is the contract of the two components.

#include <suture/annotate.h>

namespace following {

class SUTURE_INTERFACE() Joystick {
 public:
  virtual ~Joystick() = default;

  /// Says how far the stick is turned.
  SUTURE_COMMAND() SUTURE_FIELD(unit("rad")) virtual double angle() const = 0;
};

}  // namespace following
