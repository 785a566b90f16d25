#pragma once
#include <suture/component/event_task.h>

#include "one/contract.suture.h"

namespace one {

class SUTURE_COMPONENT() Bulb final : public suture::EventTask, public Lamp {
 public:
  void toggle() override { lit_ = !lit_; }
  bool lit() const override { return lit_; }
  void run() override {}

 private:
  bool lit_ = false;
  suture::Provided<Lamp> lamp_{*this, "Lamp", *this};
};

}  // namespace one
