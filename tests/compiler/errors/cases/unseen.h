#pragma once
#include <suture/annotate.h>
namespace demo {
inline void local() {
  struct SUTURE_TYPE() Hidden {
    SUTURE_FIELD(unit("m")) double x = 0;
  };
}
struct SUTURE_TYPE() Seen {
  double x = 0;
};
SUTURE_TYPE();
}  // namespace demo
