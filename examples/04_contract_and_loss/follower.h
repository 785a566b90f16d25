#pragma once
// This is the client: an axis that follows the stick while it may rely on what it reads, and holds
// still while it may not.

#include <suture/annotate.h>
#include <suture/base/errors.h>
#include <suture/component/task/periodic_task.h>

#include "04_contract_and_loss/joystick.suture.h"

namespace following {

class SUTURE_COMPONENT() Follower final : public suture::PeriodicTask {
 public:
  Follower();

  void run() override;

 private:
  void tell(suture::Errc state, const char* reaction);

  double position_ = 0;                             // rad
  suture::Errc told_ = suture::Errc::NotConnected;  // what was printed last
  bool lost_ = false;                               // and nothing fresh has come since
  suture::Required<Joystick> joystick_{*this, "Joystick"};
};

}  // namespace following
