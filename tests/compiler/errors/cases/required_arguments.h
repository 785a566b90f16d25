#pragma once
#include <demo/arm.suture.h>
#include <suture/annotate.h>
#include <suture/component/component.h>
namespace demo {
class SUTURE_COMPONENT(queue(2)) Odd : public suture::Task, public Empty {
  SUTURE_REQUIRED(max_age(10ms)) suture::Provided<Empty> third_{*this, "Third", *this};
  SUTURE_REQUIRED(queue(3)) suture::Required<Empty> fourth_{*this, "Fourth"};
  SUTURE_REQUIRED() int number_ = 0;
};
}  // namespace demo
