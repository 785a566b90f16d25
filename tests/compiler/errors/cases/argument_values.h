#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Fields {
  SUTURE_FIELD(unit("metre")) double length = 0;
  SUTURE_FIELD(unit("furlong")) double distance = 0;
  SUTURE_FIELD(range(2, 1)) double share = 0;
};
}  // namespace demo
