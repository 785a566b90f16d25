#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() wire {
  int code = 0;
};
class ArmEvent {};
class ArmColumn {};
struct GoalSlot {};
struct SUTURE_TYPE() Goal {
  double x = 0;
};
class SUTURE_INTERFACE() Arm {
 public:
  SUTURE_COMMAND() virtual void move() = 0;
  SUTURE_EVENT(name("class")) suture::EventOf<> first;
};
}  // namespace demo
