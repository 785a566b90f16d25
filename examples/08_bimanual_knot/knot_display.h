#pragma once
// This is the client that this example adds. It prints how far a knot is from its target.

#include <suture/annotate.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include "guidance/guidance.suture.h"

namespace watching {

/// Prints twice a second, as the guide knows it from what the cameras have seen.
class SUTURE_COMPONENT() KnotDisplay final : public suture::PeriodicTask {
 public:
  KnotDisplay();

  void run() override;

 private:
  suture::Required<robots::Guidance> guidance_{*this, "Guidance"};
};

}  // namespace watching
