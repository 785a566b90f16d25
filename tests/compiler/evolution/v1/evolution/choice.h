#pragma once
// This was shipped first of everything that has parts: variants, and names that changed.

#include <suture/annotate.h>

#include <cstdint>
#include <optional>
#include <variant>

namespace evolution {

enum class SUTURE_TYPE() Pace { Slow, Fast };

struct SUTURE_TYPE() Inner {
  double x = 0;
};

struct SUTURE_TYPE() Choice {
  std::variant<double, bool> value;
  std::optional<std::variant<double, bool>> second;
  Inner inner;
  Pace pace = Pace::Slow;
};

}  // namespace evolution
