#pragma once
// This is the client's end of a connection over frames.

#include <suture/loop/kj_comparisons.h>  // first

#include <suture/lane/client_end.h>
#include <suture/lane/frame/connection.h>
#include <suture/loop/control_thread.h>

#include <memory>

namespace suture::frame {

/// Belongs to the control thread. Beside what every end does, it checks if the connection's socket
/// is broken.
class FrameEnd final : public ClientEnd, private loop::Pump {
 public:
  FrameEnd(loop::ControlThread& control, std::shared_ptr<Channel> channel,
           std::shared_ptr<frame::Connection> connection);
  ~FrameEnd() noexcept(false) { close(ChannelStatus::Closed); }

 private:
  void ending() override { control_.remove(*this); }
  void pump() override;

  loop::ControlThread& control_;
  const std::shared_ptr<frame::Connection> connection_;
};

}  // namespace suture::frame
