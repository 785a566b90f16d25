"""What is generated compiles whatever its header calls its commands, events and parameters.

They have names here that functions, types and namespaces of the header have.
"""

import sys

import compiled

BESIDE = """\
#pragma once
#include <suture/annotate.h>

namespace beside {

inline double home(double x) { return x; }
inline bool isReady(int) { return true; }
constexpr double kSpeed = 2;
struct Command {};

struct SUTURE_TYPE() Pose {
  double x = 0;
};

class SUTURE_INTERFACE() Arm {
 public:
  virtual ~Arm() = default;
  SUTURE_COMMAND() virtual void home() = 0;
  SUTURE_COMMAND() virtual bool isReady() const = 0;
  SUTURE_COMMAND() virtual bool isValid() const = 0;
  SUTURE_COMMAND() virtual double kSpeed() const = 0;
  SUTURE_COMMAND() virtual void Pose() = 0;
  SUTURE_COMMAND() virtual void go(const beside::Pose& goal) = 0;
  SUTURE_EVENT() suture::EventOf<double> tanh;
  SUTURE_EVENT() suture::EventOf<int> home_;
};

}  // namespace beside
"""

if __name__ == "__main__":
    sys.exit(compiled.main({"beside.h": BESIDE}))
