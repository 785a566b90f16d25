#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void set_gain(double gain) = 0;
  SUTURE_COMMAND() virtual void setGain(int gain) = 0;
};
struct SUTURE_TYPE() Fields {
  int foo_bar = 0;
  int fooBar = 0;
  SUTURE_FIELD(name("gripper")) int tool = 0;
  SUTURE_FIELD(name("gripper")) int hand = 0;
};
enum class SUTURE_TYPE() Letters { x, X };
}  // namespace demo
namespace demo::left {
struct SUTURE_TYPE() Pose {
  double x = 0;
};
}  // namespace demo::left
namespace demo::right {
struct SUTURE_TYPE() Pose {
  double x = 0;
};
}  // namespace demo::right
