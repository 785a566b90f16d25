#pragma once
#include <suture/annotate.h>
#include <suture/component/task/event_task.h>

#include "grasp.h"
#include "gripper.h"  // it is found below this target's include root as well; the next line says its path
#include "robot/gripper.suture.h"

namespace folders {

class SUTURE_INTERFACE() Hand {
 public:
  virtual ~Hand() = default;
  SUTURE_COMMAND() virtual Grasp grasp() const = 0;
};

class SUTURE_COMPONENT() Fingers final : public suture::EventTask {
 public:
  void run() override {}

 private:
  suture::Required<Gripper> gripper_{*this, "Gripper"};
};

}  // namespace folders
