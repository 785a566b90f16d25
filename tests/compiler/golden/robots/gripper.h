#pragma once
// This is a contract that derives from one of another header.

#include <suture/annotate.h>

#include <cstdint>

#include "robots/arm.h"

namespace robots {

/// An arm with a gripper.
class SUTURE_INTERFACE(version(2), since(2)) Gripper : public Arm {
 public:
  SUTURE_COMMAND() virtual void open(SUTURE_FIELD(unit("m")) double width) = 0;
  SUTURE_COMMAND(since(2)) virtual double opening() const = 0;
  SUTURE_COMMAND(concurrent()) virtual bool fits(double width) const = 0;
  SUTURE_EVENT(since(2)) suture::EventOf<double, bool> gripped;
};

/// Members that are called as arguments of the annotations are.
class SUTURE_INTERFACE() Names {
 public:
  SUTURE_COMMAND(queue(4)) virtual void queue(std::int32_t name) = 0;
  SUTURE_COMMAND(name("title")) virtual bool name(double range, double slot, double store) = 0;
  SUTURE_COMMAND() SUTURE_FIELD(range(0, 1)) virtual double range() const = 0;
  SUTURE_EVENT(latched()) suture::EventOf<double> latched;
};

}  // namespace robots
