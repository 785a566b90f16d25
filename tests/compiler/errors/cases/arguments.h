#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Fields {
  SUTURE_FIELD(unit("m"), unit("mm")) double twice = 0;
  SUTURE_FIELD(queue(3)) double queued = 0;
  SUTURE_FIELD(unit("")) double empty = 0;
  SUTURE_FIELD(unit("m"), range(0, 1)) bool flag = false;
  SUTURE_FIELD(capacity(3)) double number = 0;
};
}  // namespace demo
