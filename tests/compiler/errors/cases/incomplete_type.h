#pragma once
#include <suture/annotate.h>
namespace demo {
struct Ahead;
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void move(const Ahead& goal) = 0;
  SUTURE_COMMAND() virtual void meet(const Contract& other) = 0;
};
}  // namespace demo
