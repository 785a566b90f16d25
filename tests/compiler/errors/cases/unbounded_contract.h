#pragma once
#include <suture/annotate.h>
#include <suture/component/component.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <string>
#include <vector>
namespace demo {
struct SUTURE_TYPE() Joints {
  SUTURE_FIELD(capacity(8)) std::vector<std::string> name;
};
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void move(const std::vector<Joints>& path) = 0;
  SUTURE_COMMAND() virtual void say(SUTURE_FIELD(capacity(9)) const std::string& text) = 0;
  SUTURE_COMMAND() virtual const Joints& measured() const = 0;
  SUTURE_EVENT() suture::EventOf<std::string> said;
};
class SUTURE_COMPONENT() Speaker : public suture::Device, public Contract {
  suture::Provided<Contract> fine_{*this, "Fine", *this};
  suture::Required<Contract> other_{*this, "Other"};
};
class SUTURE_COMPONENT() Mover : public suture::EventTask {
  suture::Required<Contract> arm_{*this, "Arm"};
  suture::Required<Contract> second_{*this, "Second"};
};
}  // namespace demo
