#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Fields {
  SUTURE_FIELD(skip()) int* cache = nullptr;
  SUTURE_FIELD(skip(), unit("m")) double both = 0;
  double plain = 0;
};
enum class SUTURE_TYPE() Letter { A SUTURE_FIELD(skip()), B };
}  // namespace demo
