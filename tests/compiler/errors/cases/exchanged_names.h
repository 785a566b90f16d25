#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Sample {
  SUTURE_FIELD(was("b")) double a = 1;
  SUTURE_FIELD(was("a")) double b = 2;
  SUTURE_FIELD(was("a")) double c = 3;
};
enum class SUTURE_TYPE() Mode {
  Off SUTURE_FIELD(was("Fast")),
  On SUTURE_FIELD(was("Off")),
  Fast SUTURE_FIELD(was("On"))
};
}  // namespace demo
