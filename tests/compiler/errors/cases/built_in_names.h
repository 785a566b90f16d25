#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() ContractEvents {
  int count = 0;
};
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND(name("subscribe")) virtual void listen() = 0;
  SUTURE_COMMAND(name("stamp")) virtual double time() const = 0;
  SUTURE_COMMAND(name("too_large")) virtual bool large() const = 0;
  SUTURE_COMMAND() virtual void move(SUTURE_FIELD(name("sent")) double at) = 0;
};
}  // namespace demo
