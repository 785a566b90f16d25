#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND(latest(), queue(4)) virtual void servo(double x) = 0;
  SUTURE_COMMAND(queue(0)) virtual void none(double x) = 0;
  SUTURE_COMMAND(ttl(0ms)) virtual void late(double x) = 0;
  SUTURE_COMMAND(latest()) virtual double measured() const = 0;
  SUTURE_EVENT(latest(), queue(4)) suture::EventOf<double> moved;
};
}  // namespace demo
