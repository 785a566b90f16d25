#pragma once
#include <suture/annotate.h>
namespace demo {
union SUTURE_TYPE() Either {
  int number;
  float fraction;
};
struct SUTURE_TYPE() Holder {
  union {
    int number;
    float fraction;
  };
};
}  // namespace demo
