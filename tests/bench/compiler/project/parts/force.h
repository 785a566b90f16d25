#pragma once
#include <suture/annotate.h>

namespace parts {

struct SUTURE_TYPE() Force {
  double value = 0;
};

}  // namespace parts
