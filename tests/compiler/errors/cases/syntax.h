#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Broken {
  int x = ;
};
}  // namespace demo
