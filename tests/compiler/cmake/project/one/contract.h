#pragma once
#include <suture/annotate.h>

namespace one {

class SUTURE_INTERFACE() Lamp {
 public:
  virtual ~Lamp() = default;
  SUTURE_COMMAND() virtual void toggle() = 0;
  SUTURE_COMMAND() virtual bool lit() const = 0;
};

}  // namespace one
