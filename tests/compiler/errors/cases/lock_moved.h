#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Sample {
  double x = 0;
};
struct SUTURE_TYPE(was("demo::Part")) Part {
  double y = 0;
};
}  // namespace demo
