#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Fields {
  int narrow : 3;
  mutable int cache = 0;
  volatile int port = 0;
  const int fixed = 1;
  int : 2;

 private:
  int hidden = 0;
};
struct Register {
  int value = 0;
  unsigned ready : 1;
  unsigned busy : 1;
  union {
    float number;
    unsigned bits;
  };
  union {
    int left, right;
  };
};
SUTURE_EXTERNAL_TYPE(Register, all(), member(busy, skip()), member(number, skip()),
                     member(bits, skip()), member(left, skip()));
}  // namespace demo
