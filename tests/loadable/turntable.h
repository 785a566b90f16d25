#pragma once
// A contract that no program knows: both its provider and its client come from a shared library.

#include <suture/annotate.h>

#include <cstdint>

namespace loadable {

class SUTURE_INTERFACE() Turntable {
 public:
  virtual ~Turntable() = default;

  SUTURE_COMMAND() virtual void turn(SUTURE_FIELD(unit("rad")) double angle) = 0;
  SUTURE_COMMAND() virtual double angle() const = 0;
};

}  // namespace loadable
