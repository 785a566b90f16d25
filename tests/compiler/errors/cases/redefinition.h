#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Twice {
  int x = 0;
};
struct SUTURE_TYPE() Twice {
  int x = 0;
};
}  // namespace demo
