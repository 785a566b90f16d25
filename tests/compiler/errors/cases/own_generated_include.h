#pragma once
#include <suture/annotate.h>

#include "own_generated_include.suture.h"
namespace demo {
struct SUTURE_TYPE() Holder {
  int x = 0;
};
}  // namespace demo
