#pragma once
// With these, components say how they are. What they say in words is in
// <suture/standard/messages.h>.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <cstdint>
#include <string>

namespace robots {

/// Says how regularly a task ran, over its last window.
struct SUTURE_TYPE() IntervalStatistics {
  SUTURE_FIELD(unit("s")) double period_average = 0;
  SUTURE_FIELD(unit("s")) double period_deviation = 0;
  SUTURE_FIELD(unit("s")) double period_min = 0;
  SUTURE_FIELD(unit("s")) double period_max = 0;
  std::uint32_t samples = 0;
  suture::Time stamp;
  bool valid = false;
};

/// Corresponds to cisst's prmKeyValue.
struct SUTURE_TYPE() KeyValue {
  SUTURE_FIELD(capacity(31)) std::string key;
  SUTURE_FIELD(capacity(127)) std::string value;
};

}  // namespace robots
