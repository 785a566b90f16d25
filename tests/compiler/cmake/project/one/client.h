#pragma once
#include <suture/component/event_task.h>

#include "one/contract.suture.h"

namespace one {

class SUTURE_COMPONENT() Hand final : public suture::EventTask {
 public:
  void run() override {}

 private:
  suture::Required<Lamp> lamp_{*this, "Lamp"};
};

}  // namespace one
