#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Holder {
  int& value;
};
}  // namespace demo
