#pragma once
// This stands for a header of another target, whose members nothing initialises.

#include <suture/annotate.h>

namespace demo {

struct SUTURE_TYPE() Bare {
  double x;
};

template <class T>
struct SUTURE_TYPE() BareBox {
  T value;
};

}  // namespace demo
