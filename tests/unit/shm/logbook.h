#pragma once
// A contract whose values have bounds, and one that adds a read without a bound to it.

#include <suture/annotate.h>

#include <string>

namespace logs {

class SUTURE_INTERFACE() Counter {
 public:
  virtual ~Counter() = default;

  SUTURE_COMMAND() virtual void count(int entries) = 0;
  SUTURE_COMMAND() virtual int entries() const = 0;
};

/// May be provided by a device only, because its text has no bound.
class SUTURE_INTERFACE() Logbook : public Counter {
 public:
  SUTURE_COMMAND() virtual const std::string& text() const = 0;
};

}  // namespace logs
