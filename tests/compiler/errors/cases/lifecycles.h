#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE(since(2), deprecated("use Pose")) Place {
  double x = 0;
};
enum class SUTURE_TYPE() Mode { On SUTURE_FIELD(since(0)), Off SUTURE_FIELD(deprecated("use On")) };
struct SUTURE_TYPE(since(0)) Sample {
  SUTURE_FIELD(since(0)) double y = 0;
};
}  // namespace demo
