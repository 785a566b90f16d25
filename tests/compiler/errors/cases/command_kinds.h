#pragma once
#include <suture/annotate.h>
#include <string>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void look() const = 0;
};
}  // namespace demo
