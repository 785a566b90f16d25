#pragma once
#include <suture/annotate.h>
#include <array>
namespace demo {
struct SUTURE_TYPE() Arrays {
  std::array<int, 0> none;
  int four[4];
  int open[];
};
}  // namespace demo
