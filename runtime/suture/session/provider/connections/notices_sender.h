#pragma once
// This sends a client in another process news of its provider.

#include <suture/lane/provider_end.h>
#include <suture/loop/control_thread.h>
#include <suture/peer.capnp.h>

#include <string>

namespace suture {

/// Belongs to the control thread. It does not matter here if the client gets the news.
class NoticesSender final : public ProviderEnd::Listener {
 public:
  NoticesSender(loop::ControlThread& control, wire::Notices::Client client)
      : control_(control), client_(kj::mv(client)) {}

  void told(ChannelStatus status) override;
  void tells(const Earlier& earlier) override;
  void refuses(const std::string& why) override;

 private:
  template <class Request>
  void send(Request request) {
    control_.spawn(request.send().ignoreResult().catch_([](kj::Exception&&) {}));
  }

  loop::ControlThread& control_;
  wire::Notices::Client client_;
};

}  // namespace suture
