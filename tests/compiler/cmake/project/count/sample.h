#pragma once
#include <suture/annotate.h>

namespace scratch {

struct SUTURE_TYPE() Sample {
  double value = 0;
};

}  // namespace scratch
