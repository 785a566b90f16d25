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
struct ArmTurnArguments {};
struct ArmTurnedPayload {};
constexpr int kArmCommands = 1, kArmEvents = 2, kArmDescription = 3, isKnownMode = 4;
inline namespace v1 {
struct OuterInnerSlot {};
}
struct ArmMoveArguments {};
struct ArmFirstPayload {};
constexpr int kLegCommands = 1;
int armCodec(int number);
int legCodec();
template <class T>
struct SUTURE_TYPE() Box {
  T content{};
};
using IntBox = Box<int>;
struct IntBoxSlot {};
enum class SUTURE_TYPE() Mode { Off, On };
struct Outer {
  struct InnerSlot {};
  struct SUTURE_TYPE() Inner {
    Mode mode = Mode::Off;
    IntBox box;
  };
};
class SUTURE_INTERFACE() Leg {};
class SUTURE_INTERFACE() Arm {
 public:
  SUTURE_COMMAND() virtual void move() = 0;
  SUTURE_COMMAND() virtual void turn(double angle) = 0;
  SUTURE_EVENT() suture::EventOf<int, double> turned;
  SUTURE_EVENT(name("class")) suture::EventOf<> first;
};
}  // namespace demo
