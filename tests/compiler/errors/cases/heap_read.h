#pragma once
#include <suture/annotate.h>
#include <string>
#include <vector>
namespace demo {
struct SUTURE_TYPE() Joints {
  SUTURE_FIELD(capacity(8)) std::vector<double> position;
};
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual Joints measured() const = 0;
  SUTURE_COMMAND() virtual const Joints& goal() const = 0;
  SUTURE_COMMAND() virtual Joints solved(int seed) const = 0;
};
}  // namespace demo
