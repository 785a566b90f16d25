#pragma once
#include <demo/arm.h>
#include <suture/annotate.h>
#include <suture/component/component.h>
namespace demo {
class SUTURE_COMPONENT() Surgeon : public suture::Task {
  suture::Required<Empty> arm_{*this, "Arm"};
};
}  // namespace demo
