#pragma once
#include <suture/annotate.h>

namespace folders {

struct SUTURE_TYPE() Force {
  double newtons = 0;
};

}  // namespace folders
