#pragma once
#include <demo/open.suture.h>
#include <suture/annotate.h>
#include <suture/component/component.h>
namespace demo {
class SUTURE_COMPONENT() Registry : public suture::Device {
  suture::Required<Forest> fine_{*this, "Fine"};
};
class SUTURE_COMPONENT() Planner : public suture::EventTask {
  suture::Required<Forest> trees_{*this, "Trees"};
};
}  // namespace demo
