#pragma once
// This is the provider's end of a connection whose data do not pass the control thread.

#include <suture/loop/kj_comparisons.h>  // first

#include <suture/lane/provider_end.h>
#include <suture/loop/control_thread.h>

#include <memory>

namespace suture {

/// Belongs to the control thread. Passes on the status of a connection by shm or frame.
class StatusPort : public ProviderEnd, private loop::Pump {
 public:
  /// `channel` will be attached to the provider; its watcher is the control thread.
  StatusPort(loop::ControlThread& control, std::shared_ptr<Channel> channel);
  ~StatusPort() noexcept(false) { close(); }

 protected:
  void pump() override { pumpStatus(); }

 private:
  void ending() override { control_.remove(*this); }

  loop::ControlThread& control_;
};

}  // namespace suture
