#pragma once
#include <suture/annotate.h>
namespace demo::suture {
struct SUTURE_TYPE() Pose {
  double x = 0;
};
}  // namespace demo::suture
