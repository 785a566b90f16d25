#pragma once
#include <suture/annotate.h>

#include "count/limits.h"
#include "numbers.h"

namespace scratch {

struct SUTURE_TYPE() Sample {
  double value = 0;
};

}  // namespace scratch
