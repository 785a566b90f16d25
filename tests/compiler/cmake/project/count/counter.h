#pragma once
#include <suture/annotate.h>

#include "count/sample.h"

namespace scratch {

class SUTURE_INTERFACE() Counter {
 public:
  virtual ~Counter() = default;
  SUTURE_COMMAND() virtual void add(const Sample& sample) = 0;
  SUTURE_COMMAND() virtual Sample sum() const = 0;
};

}  // namespace scratch
