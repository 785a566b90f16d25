#pragma once
// This is the provider: jaws that close on something soft, and touch it three times before they
// hold it.

#include <suture/annotate.h>
#include <suture/component/task/periodic_task.h>

#include "05_events/gripper.suture.h"

namespace gripping {

class SUTURE_COMPONENT() SimulatedGripper final : public suture::PeriodicTask, public Gripper {
 public:
  SimulatedGripper();

  void grasp() override;
  bool release() override;
  void run() override;

 private:
  void onStart() override;
  void become(Jaws jaws);

  Jaws jaws_ = Jaws::Open;
  int touches_ = 0;
  suture::Provided<Gripper> gripper_{*this, "Gripper", *this};
};

}  // namespace gripping
