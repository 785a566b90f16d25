#pragma once
#include <suture/annotate.h>
#include <suture/component/component.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
namespace demo {
class SUTURE_INTERFACE() Arm {
 public:
  SUTURE_COMMAND() virtual void hold() = 0;
};
class SUTURE_COMPONENT() Robot : public suture::Task, public Arm {
 public:
  void hold() override {}

 private:
  suture::Provided<Arm> arm_{*this, "Arm", *this};
  suture::Required<Arm> other_{*this, "Other"};
};
}  // namespace demo
