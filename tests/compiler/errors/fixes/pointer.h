#pragma once
#include <suture/annotate.h>

namespace demo {
struct SUTURE_TYPE() Fields {
  int* pointer = nullptr;
  const double *other{nullptr};
  std::chrono::seconds *third;
  const char* label = "grip";
  char const *braced{"tip"};
  const char *name;
  char* text = nullptr;
};
}  // namespace demo
