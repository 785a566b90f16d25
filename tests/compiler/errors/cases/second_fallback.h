#pragma once
#include <suture/annotate.h>
namespace demo {
enum class SUTURE_TYPE() Mode {
  Unknown SUTURE_FIELD(fallback()),
  Other SUTURE_FIELD(fallback())
};
}  // namespace demo
