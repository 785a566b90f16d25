#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Sample {
  SUTURE_FIELD(was("x")) double east = 0;
};
}  // namespace demo
