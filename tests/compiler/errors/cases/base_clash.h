#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() A {
  int a = 0;
};
struct SUTURE_TYPE() Taken : A {
  int base = 0;
};
struct SUTURE_TYPE() Told : A {
  SUTURE_FIELD(name("bottom")) int base = 0;
};
}  // namespace demo
