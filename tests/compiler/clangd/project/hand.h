#pragma once
#include <suture/component/task/event_task.h>

#include "gripper.suture.h"

namespace edited {

/// This hand is at its goal at once.
class SUTURE_COMPONENT() Hand final : public suture::EventTask, public Gripper {
 public:
  void move(const Opening& goal) override { opening_ = goal; }
  Opening opening() const override { return opening_; }
  void run() override {}

 private:
  Opening opening_;
  suture::Provided<Gripper> gripper_{*this, "Gripper", *this};
};

}  // namespace edited
