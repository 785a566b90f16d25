#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Sample {
  double x = 0;
};
}  // namespace demo
