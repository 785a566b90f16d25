#pragma once
#include <suture/annotate.h>
#include "own_include.suture.h"
namespace demo {
struct SUTURE_TYPE() Sample {
  double x = 0;
};
}  // namespace demo
