#pragma once
#include <suture/annotate.h>
#include <vector>
namespace demo {
template <class T>
struct SUTURE_TYPE() Stamped {
  T value;
};
struct SUTURE_TYPE() Holder {
  std::vector<Stamped<int>> values;
};
}  // namespace demo
