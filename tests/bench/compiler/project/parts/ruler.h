#pragma once
#include <suture/annotate.h>

#include "parts/length.h"

namespace parts {

class SUTURE_INTERFACE() Ruler {
 public:
  virtual ~Ruler() = default;
  SUTURE_COMMAND() virtual void mark(const Length& at) = 0;
  SUTURE_COMMAND() virtual Length measured() const = 0;
};

}  // namespace parts
