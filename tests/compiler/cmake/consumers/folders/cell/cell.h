#pragma once
#include <suture/component/task/event_task.h>

#include "grasp.h"
#include "hand.suture.h"

namespace folders {

// The headers above are of the target in the folder robot/, whose include root is that folder.
struct SUTURE_TYPE() Load {
  Grasp grasp;
  double mass = 0;
};

class SUTURE_COMPONENT() Cell final : public suture::EventTask {
 public:
  void run() override {}

 private:
  suture::Required<Hand> hand_{*this, "Hand"};
};

}  // namespace folders
