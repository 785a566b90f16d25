#pragma once
#include <suture/annotate.h>
#include <vector>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND()
  virtual void move(SUTURE_FIELD(capacity(4000000000u, 4000000000u))
                        const std::vector<std::vector<double>>& path) = 0;
};
}  // namespace demo
