#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  template <class T>
  SUTURE_COMMAND() void any(const T& value);
  SUTURE_COMMAND() virtual void gone() = delete;
};
}  // namespace demo
