#pragma once
#include <suture/component/task/event_task.h>

#include "count/counter.suture.h"

namespace scratch {

// Includes what is generated from a header of another target.
class SUTURE_COMPONENT() Watch final : public suture::EventTask {
 public:
  void run() override {}

 private:
  suture::Required<Counter> counter_{*this, "Counter"};
};

}  // namespace scratch
