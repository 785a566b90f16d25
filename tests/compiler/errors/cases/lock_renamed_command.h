#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Arm {
 public:
  virtual ~Arm() = default;
  SUTURE_COMMAND() virtual double velocity() const = 0;
};
}  // namespace demo
