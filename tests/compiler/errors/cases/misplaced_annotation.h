#pragma once
#include <suture/annotate.h>
namespace demo {
class Plain {
 public:
  SUTURE_COMMAND() virtual void move(SUTURE_FIELD(unit("m")) double x) = 0;
  SUTURE_EVENT() suture::EventOf<> moved;
};
SUTURE_TYPE() void function();
SUTURE_COMPONENT() extern int variable;
struct SUTURE_TYPE() Ahead;
}  // namespace demo
