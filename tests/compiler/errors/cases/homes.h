#pragma once
#include <suture/annotate.h>
namespace demo {
namespace {
struct SUTURE_TYPE() Hidden {
  int x = 0;
};
}  // namespace
class Outer {
 public:
  struct SUTURE_TYPE() Inner {
    int x = 0;
  };
};
struct SUTURE_TYPE() First {
  int x = 0;
};
}  // namespace demo
namespace other {
struct SUTURE_TYPE() Second {
  int x = 0;
};
}  // namespace other
