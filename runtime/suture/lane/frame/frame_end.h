#pragma once
// The client's end of a connection over frames.

#include <suture/loop/kj_comparisons.h>  // first

#include <suture/lane/client_end.h>
#include <suture/lane/frame/connection.h>
#include <suture/loop/control_thread.h>

#include <memory>

namespace suture {

/// Looks whether the connection's socket carries nothing any more, beside what every end does.
/// Belongs to the control thread.
class FrameEnd final : public rpc::ClientEnd, private rpc::Pump {
 public:
  FrameEnd(rpc::ControlThread& control, std::shared_ptr<Channel> channel,
           std::shared_ptr<frame::Connection> connection);
  ~FrameEnd() noexcept(false) { close(ChannelStatus::Closed); }

 private:
  void ending() override { control_.remove(*this); }
  void pump() override;

  rpc::ControlThread& control_;
  const std::shared_ptr<frame::Connection> connection_;
};

}  // namespace suture
