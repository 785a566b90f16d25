#pragma once
#include <suture/annotate.h>
namespace demo {
struct Plain {};
struct SUTURE_TYPE() A {
  int a = 0;
};
struct SUTURE_TYPE() Shared : virtual A {};
struct SUTURE_TYPE() Hidden : private A {};
struct SUTURE_TYPE() Unknown : Plain {};
}  // namespace demo
