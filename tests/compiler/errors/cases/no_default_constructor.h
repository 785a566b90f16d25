#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Made {
  explicit Made(int n) : number(n) {}
  int number;
};
struct SUTURE_TYPE() Never {
  Never() = delete;
  int number;
};
}  // namespace demo
