#pragma once
#include <suture/annotate.h>

#include <string>
namespace demo {
#pragma pack(push, 1)
class SUTURE_TYPE() Hidden {
  SUTURE_FRIEND()
  signed char tag_[3] = {};
  double width_ = 0;
};
struct SUTURE_TYPE() Owner {
  signed char tag = 0;
  SUTURE_FIELD(capacity(8)) std::string name;
  double width = 0;
};
#pragma pack(pop)
}  // namespace demo
