#pragma once
#include <suture/annotate.h>

namespace demo {
struct SUTURE_TYPE() Fields {
  int* pointer = nullptr;
  const double *other{nullptr};
  std::chrono::seconds *third;
};
}  // namespace demo
