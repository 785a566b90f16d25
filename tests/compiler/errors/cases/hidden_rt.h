#pragma once
#include <suture/annotate.h>
namespace rt {
struct SUTURE_TYPE() Pose {
  double x = 0;
};
}  // namespace rt
