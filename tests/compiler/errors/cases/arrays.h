#pragma once
#include <suture/annotate.h>
#include <array>
namespace demo {
struct SUTURE_TYPE() Arrays {
  std::array<int, 0> none;
  int four[4];
  int open[];
};
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void move(const double (&positions)[7]) = 0;
};
}  // namespace demo
