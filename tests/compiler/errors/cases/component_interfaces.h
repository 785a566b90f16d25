#pragma once
#include <demo/arm.suture.h>
#include <suture/annotate.h>
#include <suture/component/component.h>
namespace demo {
class SUTURE_COMPONENT(optional()) Twice : public suture::Task, public Empty {
  suture::Provided<Empty> left_{*this, "Arm", *this};
  suture::Provided<Empty> right_{*this, "Arm", *this};
  suture::Required<Empty> arm_{*this, "Arm"};
  SUTURE_REQUIRED(optional(), max_age(0ms)) suture::Required<Empty> other_{*this, "Other"};
};
}  // namespace demo
