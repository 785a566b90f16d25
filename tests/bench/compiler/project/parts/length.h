#pragma once
#include <suture/annotate.h>

namespace parts {

struct SUTURE_TYPE() Length {
  double value = 0;
};

}  // namespace parts
