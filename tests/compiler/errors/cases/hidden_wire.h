#pragma once
#include <suture/annotate.h>
namespace wire {
struct SUTURE_TYPE() Pose {
  double x = 0;
};
}  // namespace wire
