#pragma once
#include <suture/annotate.h>
namespace demo {
enum SUTURE_TYPE() Leaky { kOne };
enum class SUTURE_TYPE() Marked { One SUTURE_FIELD(unit("m")) };
}  // namespace demo
