#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void move(int steps) = 0;
  SUTURE_COMMAND() virtual void move(double metres) = 0;
};
struct SUTURE_TYPE() Fields {
  int foo_bar = 0;
  int fooBar = 0;
};
enum class SUTURE_TYPE() Letters { x, X };
}  // namespace demo
