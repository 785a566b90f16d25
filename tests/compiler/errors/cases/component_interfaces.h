#pragma once
#include <suture/annotate.h>
#include <suture/component/component.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
namespace demo {
class SUTURE_INTERFACE() Arm {};
class SUTURE_COMPONENT(optional()) Twice : public suture::Task, public Arm {
  suture::Provided<Arm> left_{*this, "Arm", *this};
  suture::Provided<Arm> right_{*this, "Arm", *this};
  suture::Required<Arm> arm_{*this, "Arm"};
  SUTURE_REQUIRED(optional(), max_age(0ms)) suture::Required<Arm> other_{*this, "Other"};
};
}  // namespace demo
