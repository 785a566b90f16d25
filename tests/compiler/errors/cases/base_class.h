#pragma once
#include <suture/annotate.h>
namespace demo {
struct A {};
struct SUTURE_TYPE() B : virtual A {
  int x = 0;
};
class SUTURE_INTERFACE() Contract : public A {};
}  // namespace demo
