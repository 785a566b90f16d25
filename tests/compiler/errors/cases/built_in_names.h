#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() ContractEvents {
  int count = 0;
};
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void subscribe() = 0;
  SUTURE_COMMAND() virtual double stamp() const = 0;
  SUTURE_COMMAND() virtual bool too_large() const = 0;
  SUTURE_COMMAND() virtual void move(double sent) = 0;
  SUTURE_EVENT() suture::EventOf<> state;
};
}  // namespace demo
