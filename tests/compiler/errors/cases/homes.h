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
  class SUTURE_INTERFACE() Contract {};

 private:
  struct SUTURE_TYPE() Inner {
    int x = 0;
  };
};
template <class T>
struct Box {
  enum class SUTURE_TYPE() Lid { Open, Closed };
};
struct SUTURE_TYPE() First {
  int x = 0;
};
}  // namespace demo
