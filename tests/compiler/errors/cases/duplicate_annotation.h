#pragma once
#include <suture/annotate.h>
#include <suture/component/provided.h>
namespace demo {
class SUTURE_INTERFACE() Contract {
 public:
  virtual ~Contract() = default;
  SUTURE_COMMAND() virtual void move() = 0;
};
class SUTURE_COMPONENT() Robot : public suture::Device, public Contract {
 public:
  SUTURE_COMMAND() void move() override {}
};
}  // namespace demo
