#pragma once
#include <suture/annotate.h>
#include <suture/component/component.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include <optional>

#include "demo/arm.suture.h"
namespace demo {
class SUTURE_COMPONENT() Surgeon : public suture::Task, public Empty {
  suture::Required<Empty> arm_{*this, "Arm"};
  suture::Provided<Empty> own_{*this, "Own", *this};
  std::optional<decltype(arm_.enable.start())> enabling_;
  std::optional<decltype(arm_.on().moved.next())> moved_;
  decltype(own_.emit())* emitter_ = nullptr;
  decltype(std::declval<Empty&>().enable())* other_ = nullptr;
};
}  // namespace demo
