#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND(queue(8)) virtual void move(int steps) = 0;
};
}  // namespace demo
