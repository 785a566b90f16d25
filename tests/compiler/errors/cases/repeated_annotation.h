#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() SUTURE_TYPE(name("Two")) Twice {
  SUTURE_FIELD(unit("m")) SUTURE_FIELD(range(0, 1)) double x = 0;
};
}  // namespace demo
