#pragma once
// These types came after those of v1.

#include <suture/annotate.h>

#include <cstdint>
#include <optional>
#include <variant>

namespace evolution {

enum class SUTURE_TYPE() Pace { Quick SUTURE_FIELD(was("Fast")), Slow };  // renamed, reordered

struct SUTURE_TYPE(was("Inner")) Part {  // renamed
  double x = 0;
};

struct SUTURE_TYPE() Choice {
  std::variant<std::int32_t, double, bool> value;  // one more
  std::optional<std::variant<std::int32_t, double, bool>> second;
  Part inner;
  Pace pace = Pace::Slow;
};

}  // namespace evolution
