#pragma once
#include <suture/annotate.h>
#include <array>
namespace msgs {
struct SUTURE_TYPE() Pose {
  double x = 0;
};
}  // namespace msgs
namespace demo::msgs {
class SUTURE_INTERFACE() Arm {
 public:
  SUTURE_COMMAND() virtual void move(const ::msgs::Pose& goal) = 0;
  SUTURE_COMMAND() virtual std::array<::msgs::Pose, 2> both() const = 0;
  SUTURE_EVENT() suture::EventOf<::msgs::Pose> moved;
};
}  // namespace demo::msgs
