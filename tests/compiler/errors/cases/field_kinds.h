#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Fields {
  int narrow : 3;
  mutable int cache = 0;
  volatile int port = 0;
  const int fixed = 1;
  int : 2;

 private:
  int hidden = 0;
};
}  // namespace demo
