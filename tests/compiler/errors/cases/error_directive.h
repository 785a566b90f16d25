#pragma once
#include <suture/annotate.h>
#error this header needs another platform
namespace demo {
struct SUTURE_TYPE() Holder {
  int x = 0;
};
}  // namespace demo
