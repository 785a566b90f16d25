#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Arm {
 public:
  virtual ~Arm() = default;
  SUTURE_COMMAND() virtual void hold() = 0;
  SUTURE_COMMAND() virtual double reach(const double& x, bool fast) const = 0;
};
class SUTURE_INTERFACE() Empty {};
}  // namespace demo
