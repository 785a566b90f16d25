#pragma once
// This is the provider's end of a connection over frames.

#include <suture/lane/frame/connection.h>
#include <suture/lane/status_port.h>

#include <memory>
#include <utility>

namespace suture::frame {

/// Belongs to the control thread. Beside what a status port does, it tells the client if this
/// process has refused its frames.
class ProviderPort final : public StatusPort {
 public:
  ProviderPort(loop::ControlThread& control, std::shared_ptr<Channel> channel,
               std::shared_ptr<Connection> connection)
      : StatusPort(control, std::move(channel)), connection_(std::move(connection)) {}

 private:
  void pump() override;

  const std::shared_ptr<Connection> connection_;
  bool told_ = false;
};

}  // namespace suture::frame
