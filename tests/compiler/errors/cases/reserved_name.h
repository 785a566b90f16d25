#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Reader {
  int x = 0;
};
class SUTURE_INTERFACE() Client {};
struct SUTURE_TYPE(name("winkelÄ")) Angle {
  SUTURE_FIELD(name("9lives")) int lives = 0;
};
enum class SUTURE_TYPE() End { eof };
}  // namespace demo
