#pragma once
#include <suture/annotate.h>
namespace demo {
inline constexpr double load = 1;
enum Action { store };
void isValid(int value);
namespace wire {
struct Goal {};
}  // namespace wire
struct SUTURE_TYPE() Goal {
  double x = 0;
};
}  // namespace demo
