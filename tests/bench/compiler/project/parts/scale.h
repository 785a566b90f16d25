#pragma once
#include <suture/annotate.h>

#include "parts/force.h"

namespace parts {

class SUTURE_INTERFACE() Scale {
 public:
  virtual ~Scale() = default;
  SUTURE_COMMAND() virtual void tare() = 0;
  SUTURE_COMMAND() virtual Force measured() const = 0;
};

}  // namespace parts
