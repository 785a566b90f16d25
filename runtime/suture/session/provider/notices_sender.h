#pragma once
// Tells a client in another process what befalls its provider.

#include <suture/lane/lane_kind.h>
#include <suture/loop/control_thread.h>
#include <suture/peer.capnp.h>

namespace suture {

/// Whether the client hears does not matter here. Belongs to the control thread.
class NoticesSender final : public rpc::ProviderEnd::Listener {
 public:
  /// `replays`: the lane's way to tell of a replay. `events`: how the client's contract numbers
  /// them on the wire.
  NoticesSender(rpc::ControlThread& control, wire::Notices::Client client, TellReplay replays,
                WireNumbers events)
      : control_(control), client_(kj::mv(client)), replays_(std::move(replays)), events_(events) {}

  void told(ChannelStatus status) override;
  void replays(std::uint16_t event, Time stamp) override;
  kj::Promise<void> tallies(const Tally& tally) override;
  void tells(const Earlier& earlier) override;

 private:
  template <class Request>
  void send(Request request) {
    control_.spawn(request.send().ignoreResult().catch_([](kj::Exception&&) {}));
  }

  rpc::ControlThread& control_;
  wire::Notices::Client client_;
  const TellReplay replays_;
  const WireNumbers events_;
};

}  // namespace suture
