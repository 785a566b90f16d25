#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Pose {
  double x = 0;
};
struct SUTURE_TYPE() Sample {
  Pose pose;
};
}  // namespace demo
