#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void go(SUTURE_FIELD(unit("km/hr")) double speed) = 0;
  SUTURE_COMMAND() SUTURE_FIELD(range(1, -1)) virtual double share() const = 0;
  SUTURE_EVENT() SUTURE_FIELD(unit("Nm.m")) suture::EventOf<double> torque;
  SUTURE_EVENT() SUTURE_FIELD() SUTURE_FIELD(unit("m/sec")) suture::EventOf<bool, double> moved;
};
}  // namespace demo
