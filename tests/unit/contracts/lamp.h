#pragma once
// A contract that has the standard messages among its members.

#include <suture/annotate.h>
#include <suture/standard/messages.h>

namespace contracts {

class SUTURE_INTERFACE() Lamp : public suture::Messages {
 public:
  SUTURE_COMMAND() virtual void light(bool on) = 0;
  SUTURE_COMMAND() virtual bool lit() const = 0;
};

}  // namespace contracts
