#pragma once
#include <suture/annotate.h>
namespace demo {
class SUTURE_INTERFACE() Arm {
 public:
  SUTURE_COMMAND() virtual void on() = 0;
  SUTURE_COMMAND() virtual void emit() = 0;
  SUTURE_COMMAND() virtual void name() = 0;
  SUTURE_COMMAND() virtual void Command() = 0;
  SUTURE_COMMAND() virtual void ArmCommand() = 0;
  SUTURE_COMMAND() virtual int ArmColumn() const = 0;
  SUTURE_EVENT() suture::EventOf<> ArmEvent;
  SUTURE_EVENT(name("events")) suture::EventOf<> Events;
  SUTURE_EVENT() suture::EventOf<> on_event;
};
}  // namespace demo
