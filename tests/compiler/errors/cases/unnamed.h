#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Unnamed {
  struct {
    int x;
  } inner;
};
struct SUTURE_TYPE() {
  int x;
} instance;
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void move(int) = 0;
};
}  // namespace demo
