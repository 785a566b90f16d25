#pragma once
// The client that this example adds: prints how far a knot is from its target.

#include <suture/annotate.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include "guidance/guidance.suture.h"

namespace watching {

/// Twice a second, as the guide knows it: by what the cameras have seen.
class SUTURE_COMPONENT() KnotDisplay final : public suture::PeriodicTask {
 public:
  KnotDisplay();

  void run() override;

 private:
  suture::Required<robots::Guidance> guidance_{*this, "Guidance"};
};

}  // namespace watching
