#pragma once
// This ends what belongs to a control thread, however long that is busy.

#include <suture/loop/control_thread.h>
#include <suture/rt/standard_error.h>

#include <chrono>
#include <string>

namespace suture::loop {

/// Any other thread. Runs `work` on the control thread and waits for it, since nothing that it
/// still uses may go before. It may run again after it has run. While the thread is busy, this says
/// on standard error that `who` waits. Returns why it failed; "" if it did not.
template <class Work>
std::string runToTheEnd(ControlThread& control, const std::string& who, const Work& work) {
  for (;;) {
    try {
      control.run(std::chrono::seconds(10), work);
      return "";
    } catch (const ControlFailure& failure) {
      if (failure.kind() != ControlFailure::Kind::TimedOut) return failure.what();
      rt::printUnlessFull(who + failure.what());
    }
  }
}

}  // namespace suture::loop
