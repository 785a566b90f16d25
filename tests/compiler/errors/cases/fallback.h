#pragma once
#include <suture/annotate.h>
namespace demo {
enum class SUTURE_TYPE() Mode {
  Unknown SUTURE_FIELD(fallback()),
  Other,
  Third SUTURE_FIELD(skip())
};
struct SUTURE_TYPE() Fields {
  SUTURE_FIELD(fallback()) int x = 0;
};
}  // namespace demo
