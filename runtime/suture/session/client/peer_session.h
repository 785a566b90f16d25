#pragma once
// This is the session of this process with a peer whose components it uses.

#include <suture/component/channel/peer_state.h>
#include <suture/framing/link.h>
#include <suture/lane/lanes.h>
#include <suture/names/manager_link.h>
#include <suture/peer.capnp.h>
#include <suture/session/client/heartbeat.h>
#include <suture/session/clock_offset.h>

#include <memory>
#include <string>
#include <vector>

namespace suture {

/// Limits the time that a peer may take for each answer while a new socket is opened.
inline constexpr Duration kDialLimit = std::chrono::seconds(2);

/// Says who this process is to its peers.
struct SessionIdentity {
  std::string process;
  std::uint64_t incarnation = 0;
};

/// Belongs to the control thread; outlives its promises. Owns what all connections from here to
/// that process share: the control link, the heartbeat, the estimate of the peer's clock, and for
/// each lane what that keeps. The control link carries no payload, so no connection holds up
/// another here. It ends with the last connection.
class PeerSession final : private ClientSession {
 public:
  /// `bytes` is a connection to `process`, on which nothing has been sent.
  PeerSession(loop::ControlThread& control, ManagerLink& manager, const Lanes& lanes,
              ProcessRecord process, net::ByteStream bytes);
  ~PeerSession() noexcept(false);
  KJ_DISALLOW_COPY(PeerSession);

  /// Says hello. Call it first, and once.
  kj::Promise<void> greet(const SessionIdentity& self);
  /// Compares the clocks. Call it next, and once.
  kj::Promise<void> compareClocks();

  wire::Peer::Client peer() { return peer_; }
  std::uint64_t peersIncarnation() const { return peersIncarnation_; }
  const ClockOffset& clock() const { return clock_; }
  /// Returns what is known of the peer, for connections to read.
  std::shared_ptr<const PeerState> state() const { return state_; }
  LaneClient& lane(std::size_t which) { return *lanes_[which]; }

  /// Watches a component of the peer, and the control link.
  kj::Own<Heartbeat::Watch> watch(const std::string& component, Heartbeat::Bounds bounds,
                                  Heartbeat::Lost lost) {
    return heartbeat_.watch(component, bounds, kj::mv(lost));
  }
  /// A connection gives the peer up after `silence`, so no socket may break before.
  void bear(Duration silence);

  /// Returns true if the control link has ended, or the peer has been silent for longer than any
  /// connection bears.
  bool broken() const { return closed_ || heartbeat_.silent(); }
  /// Returns true if the control link has ended.
  bool closed() const { return closed_; }

 private:
  loop::ControlThread& control() override { return control_; }
  bool carriesDescriptors() const override { return carriesDescriptors_; }
  bool hasOneClock() const override { return clock_.isOne(); }
  kj::Promise<LaneSocket> openSocket(const char* lane) override;

  kj::Promise<void> askForClock(Time begun, unsigned times);
  template <class T>
  kj::Promise<T> inTime(kj::Promise<T> step);
  void follow(Time asked, wire::Peer::PingResults::Reader answer);
  void noteClock();
  void tellClock();

  loop::ControlThread& control_;
  ManagerLink& manager_;
  const ProcessRecord process_;  // the peer's, as it was reached
  const int socket_;
  const bool carriesDescriptors_;
  framing::Link link_;
  wire::Peer::Client peer_;
  std::uint64_t peersIncarnation_ = 0;
  ClockOffset clock_;  // the peer's
  const std::shared_ptr<PeerState> state_ = std::make_shared<PeerState>();
  Duration toldError_{0};  // how wrong the peer was last told its clock may be
  Duration longest_{0};    // the longest silence that a connection bears
  Heartbeat heartbeat_;
  std::vector<kj::Own<LaneClient>> lanes_;  // in the order of the process's lanes
  bool closed_ = false;
  kj::Promise<void> telling_ = kj::READY_NOW;
  kj::Promise<void> ending_;  // last: cancelled first
};

}  // namespace suture
