#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Fields {
  SUTURE_FIELD(unti("m")) double length = 0;
  SUTURE_FIELD(colour("red")) double width = 0;
};
}  // namespace demo
