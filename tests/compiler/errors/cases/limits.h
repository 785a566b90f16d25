#pragma once
#include <suture/annotate.h>

#include <array>
namespace demo {
struct SUTURE_TYPE() Volume {
  std::array<std::array<std::array<double, 1024>, 1024>, 1024> voxels{};
};
template <int Levels>
struct Nested {
  using Type = std::array<typename Nested<Levels - 1>::Type, 1>;
};
template <>
struct Nested<0> {
  using Type = int;
};
struct SUTURE_TYPE() Deep {
  Nested<70>::Type value{};
};
}  // namespace demo
