#pragma once
#include <suture/annotate.h>
#include <not/there.h>
namespace demo {
struct SUTURE_TYPE() Holder {
  Unknown x;
};
}  // namespace demo
