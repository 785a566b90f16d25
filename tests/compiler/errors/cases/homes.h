#pragma once
#include <suture/annotate.h>
namespace demo {
namespace {
struct SUTURE_TYPE() Hidden {
  int x = 0;
};
}  // namespace
namespace {
struct Foreign {
  int x = 0;
};
enum class Kind { One, Two };
template <class T>
struct SUTURE_TYPE() Case {
  T content{};
};
}  // namespace
template <class T>
struct Shelf {
  T content{};
};
using HiddenShelf = Shelf<Foreign>;
using IntCase = Case<int>;
SUTURE_EXTERNAL_TYPE(Foreign);
SUTURE_EXTERNAL_TYPE(Kind);
SUTURE_EXTERNAL_TYPE(HiddenShelf);
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
