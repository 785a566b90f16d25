#pragma once
// This is a contract of which a connection would take more memory than a peer may.

#include <suture/annotate.h>

#include "unit/large_values/picture.h"

namespace large_values {

class SUTURE_INTERFACE() Hall {
 public:
  virtual ~Hall() = default;

  SUTURE_COMMAND(queue(2000)) virtual void fill(const Picture& picture) = 0;
};

}  // namespace large_values
