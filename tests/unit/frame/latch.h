#pragma once
// This is a contract whose commands and events carry no values.

#include <suture/annotate.h>

namespace latches {

class SUTURE_INTERFACE() Latch {
 public:
  virtual ~Latch() = default;

  SUTURE_COMMAND() virtual void close() = 0;
  SUTURE_EVENT() suture::EventOf<> closed;
};

}  // namespace latches
