#pragma once
#include <suture/annotate.h>

#include <limits>
#include <optional>
namespace demo {
struct SUTURE_TYPE() Limits {
  SUTURE_FIELD(range(1, 2)) double low = 0.5;
  SUTURE_FIELD(range(1, 2)) int unsaid;
  SUTURE_FIELD(range(-1, 2)) double high = std::numeric_limits<double>::infinity();
  SUTURE_FIELD(range(1, 2)) double within = 2;
  SUTURE_FIELD(range(1, 2)) std::optional<double> none;
};
}  // namespace demo
