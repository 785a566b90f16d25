#pragma once
#include <suture/annotate.h>
#include <vector>
namespace demo {
struct Inner {
  int x = 0;
};
enum class State { On, Off };
struct SUTURE_TYPE() Outer {
  Inner inner;
  std::vector<State> states;
};
}  // namespace demo
