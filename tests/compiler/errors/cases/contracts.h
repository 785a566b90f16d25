#pragma once
#include <suture/annotate.h>
namespace demo {
class Plain {};
class SUTURE_INTERFACE() Base {
 public:
  SUTURE_COMMAND() virtual void hold() = 0;
};
class SUTURE_INTERFACE() Other {};
class SUTURE_INTERFACE() FromPlain : public Plain {};
class SUTURE_INTERFACE() FromTwo : public Base, public Other {};
class SUTURE_INTERFACE() Hidden : Base {};
class SUTURE_INTERFACE() Virtual : public virtual Base {};
class SUTURE_INTERFACE(version(2)) Derived : public Base {
 public:
  SUTURE_COMMAND() void hold() override = 0;
  SUTURE_COMMAND(optional()) virtual void park() = 0;
};
class SUTURE_INTERFACE() Pair {
 public:
  SUTURE_EVENT() SUTURE_FIELD(range(0, 1)) suture::EventOf<double, double> moved;
  SUTURE_EVENT() SUTURE_FIELD() suture::EventOf<> stopped;
  SUTURE_FIELD() SUTURE_EVENT() SUTURE_FIELD(unit("m/s")) suture::EventOf<bool, double> right;
  SUTURE_EVENT() SUTURE_FIELD(name("x")) suture::EventOf<double> named;
  SUTURE_COMMAND() SUTURE_FIELD(was("y")) virtual double place() const = 0;
};
}  // namespace demo
