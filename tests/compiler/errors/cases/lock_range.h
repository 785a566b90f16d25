#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Sample {
  SUTURE_FIELD(range(0, 2)) double x = 0;
};
}  // namespace demo
