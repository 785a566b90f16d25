#pragma once
#include <suture/annotate.h>
namespace demo {
enum class SUTURE_TYPE() Flag { Left = 1, Right = 2 };
enum class SUTURE_TYPE() Mode { Error = -1, Idle, Run };
struct SUTURE_TYPE() Defaults {
  Flag braces{};
  Flag call = Flag();
  Flag cast = static_cast<Flag>(7);
  Flag given = Flag::Right;
  Flag unsaid;
  Mode zero{};
};
template <class T>
struct SUTURE_TYPE() Box {
  T value{};
};
using FlagBox = Box<Flag>;
}  // namespace demo
