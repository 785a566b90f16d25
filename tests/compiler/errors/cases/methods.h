#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() Contract() = default;
  SUTURE_COMMAND() static void everyone();
  SUTURE_COMMAND() void plain();
  SUTURE_COMMAND() virtual void operator()() = 0;
  SUTURE_COMMAND() virtual void once() && = 0;
  virtual void forgotten() = 0;
  int data = 0;

 private:
  SUTURE_COMMAND() virtual void hidden() = 0;
};
}  // namespace demo
