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
  SUTURE_FIELD(skip()) union {
    int left;
    float right;
  };
  SUTURE_FIELD(skip()) struct {
    int both;
  };
};
}  // namespace demo
