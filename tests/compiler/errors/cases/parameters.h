#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void out(int& result) = 0;
  SUTURE_COMMAND() virtual void take(int&& value) = 0;
  SUTURE_COMMAND() virtual void guess(int value = 3) = 0;
  SUTURE_COMMAND() virtual void many(int count, ...) = 0;
  SUTURE_COMMAND() virtual void go(SUTURE_FIELD(since(1)) double x) = 0;
  SUTURE_COMMAND() virtual void at(SUTURE_FIELD(was("p")) int* place) = 0;
};
}  // namespace demo
