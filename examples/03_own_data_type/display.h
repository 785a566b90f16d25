#pragma once
// This is the client. It prints what the tracker at the other end sees.

#include <suture/annotate.h>
#include <suture/component/task/periodic_task.h>

#include "03_own_data_type/tracker.suture.h"

namespace tracking {

class SUTURE_COMPONENT() Display final : public suture::PeriodicTask {
 public:
  Display();

  void run() override;

 private:
  suture::Required<Tracker> tracker_{*this, "Tracker"};
};

}  // namespace tracking
