#pragma once
#include <suture/annotate.h>
#define FIELD(type, name) SUTURE_FIELD(unit("m")) type name
namespace demo {
struct SUTURE_TYPE() Generated {
  FIELD(int*, x);
};
}  // namespace demo
