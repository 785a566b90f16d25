#pragma once
#include <suture/annotate.h>
#include <functional>
namespace demo {
class Half {};
class Odd {};
class None {};
}  // namespace demo
template <>
struct suture::Wire<demo::Half> {
  using Type = int;
  static Type to(const demo::Half& value);
};
template <>
struct suture::Wire<demo::Odd> {
  using Type = std::function<void()>;
  static Type to(const demo::Odd& value);
  static demo::Odd from(const Type& form);
};
namespace demo {
struct SUTURE_TYPE() Opaque {
  Half half;
  Odd odd;
  None none;
};
}  // namespace demo
