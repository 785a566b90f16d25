"""What is generated compiles whatever its header calls its commands, events and parameters.

They have names here that generated code uses itself, or that functions, types and namespaces of the header have.
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

SCOPE = """\
#pragma once
#include <suture/annotate.h>
#include <string>

namespace scope {

class SUTURE_INTERFACE() Words {
 public:
  virtual ~Words() = default;
  SUTURE_COMMAND() virtual void Command() = 0;
  SUTURE_COMMAND() virtual int ReadCommand() const = 0;
  SUTURE_COMMAND() virtual int QualifiedReadCommand(int depth) const = 0;
  SUTURE_COMMAND() virtual int ReturningCommand(int depth) = 0;
  SUTURE_COMMAND() virtual void NoSlot() = 0;
  SUTURE_COMMAND() virtual void Component() = 0;
  SUTURE_COMMAND() virtual void RequiredBase() = 0;
  SUTURE_COMMAND() virtual void interfaceInfo() = 0;
  SUTURE_COMMAND() virtual void Subscription() = 0;
  SUTURE_COMMAND() virtual void Provided() = 0;
  SUTURE_COMMAND() virtual void scope() = 0;
  SUTURE_COMMAND() virtual void execute() = 0;
  SUTURE_COMMAND() virtual void Errc() = 0;
  SUTURE_COMMAND() virtual void Dispatch() = 0;
  SUTURE_COMMAND() virtual void Scratch(double scratch) = 0;
  SUTURE_COMMAND() virtual double stop(int arguments_, int slot) = 0;
  SUTURE_COMMAND() virtual void hold(int slot, SUTURE_FIELD(name("other")) int slot_, int store) = 0;
  SUTURE_EVENT() suture::EventOf<int> moved;
};

class SUTURE_INTERFACE() News : public Words {
 public:
  SUTURE_COMMAND(name("info")) virtual int InterfaceInfo() const = 0;
  SUTURE_COMMAND() virtual int level() const = 0;
  SUTURE_EVENT() suture::EventOf<int> Subscription;
  SUTURE_EVENT() suture::EventOf<> Emitter;
  SUTURE_EVENT() suture::EventOf<int> RequiredBase;
  SUTURE_EVENT() suture::EventOf<int, std::int32_t> ProvidedBase;
  SUTURE_EVENT() suture::EventOf<int> Required;
  SUTURE_EVENT() suture::EventOf<int> Provided;
  SUTURE_EVENT() suture::EventOf<int> EventId;
  SUTURE_EVENT() suture::EventOf<int> scope;
  SUTURE_EVENT() suture::EventOf<int> last;
};

}  // namespace scope
"""

if __name__ == "__main__":
    sys.exit(compiled.main({"beside.h": BESIDE, "scope.h": SCOPE}))
