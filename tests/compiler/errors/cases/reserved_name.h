#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE(name("Reader")) Card {
  int x = 0;
};
enum class SUTURE_TYPE(name("Text")) Kind { Short, Long };
class SUTURE_INTERFACE(name("Client")) Contract {};
struct SUTURE_TYPE(name("winkelÄ")) Angle {
  SUTURE_FIELD(name("9lives")) int lives = 0;
};
enum class SUTURE_TYPE() End { last SUTURE_FIELD(name("eof")) };
}  // namespace demo
