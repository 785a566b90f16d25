#pragma once
#include <suture/annotate.h>
namespace demo {
template <class T>
struct SUTURE_TYPE() Stamped {
  T value{};
  SUTURE_FIELD(capacity(2)) int count = 0;
};
using StampedInt = Stamped<int>;
using Again = Stamped<int>;
template <>
struct SUTURE_TYPE() Stamped<double> {
  int other = 0;
};
}  // namespace demo
