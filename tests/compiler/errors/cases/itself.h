#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Node {
  Node next;
};
}  // namespace demo
