#pragma once
// One required interface of this process, connected to a provided one of another.

#include <suture/component/channel/ledger.h>
#include <suture/component/required.h>
#include <suture/framing/link.h>
#include <suture/lane/client_end.h>
#include <suture/lane/frame/frame_links.h>
#include <suture/lane/lane.h>
#include <suture/lane/shm/shared_channel.h>
#include <suture/names/manager_link.h>
#include <suture/net/address.h>
#include <suture/peer.capnp.h>
#include <suture/session/clock_offset.h>
#include <suture/session/heartbeat.h>
#include <suture/session/network.h>
#include <suture/session/notices_receiver.h>
#include <suture/wiring/endpoint.h>

#include <functional>
#include <memory>
#include <string>

namespace suture {

/// Owns a link of its own, so that no other connection can hold it up. When the link breaks the
/// required interface is Lost at once, and the connection is made anew, with back-off, for as long
/// as this lives. Belongs to the control thread; outlives its promises.
class RemoteConnection {
 public:
  /// The control thread calls these with news of the connection.
  struct Told {
    /// Takes each channel, when the connection has been made or made anew.
    std::function<void(std::shared_ptr<Channel>)> made;
    /// Hears by the channel's name why it is lost, in words, before it is.
    std::function<void(const std::string& channel, std::string why)> lost;
  };

  /// `from` and `to` with their processes. `incarnation`: of this one. `ledger`: the sums of the
  /// connection's name.
  RemoteConnection(rpc::ControlThread& control, FrameLinks& frames, ManagerLink& manager,
                   RequiredBase& required, Endpoint from, Endpoint to, Lane lane, Told told,
                   const Interposer& interposer, std::shared_ptr<ConnectionWatch> watch,
                   std::uint64_t incarnation, std::shared_ptr<Ledger> ledger);
  ~RemoteConnection() noexcept(false);

  /// Connects, waiting at most `patience` for the other process and its component. Rejects with the
  /// reason.
  kj::Promise<void> open(Duration patience);
  /// Takes the connection down for good: that is no loss to the client.
  void end();

 private:
  /// `limit`: how long the peer may take for each answer.
  kj::Promise<void> connect(Duration patience, Duration limit);
  kj::Promise<void> dial(const ProcessRecord& process, Duration limit);
  kj::Promise<void> introduce(Duration limit);
  kj::Promise<void> greet();
  kj::Promise<void> compareClocks(unsigned times);
  kj::Promise<void> requireClocksThatCanTell();
  /// What is asked for: the faster ones first, and calls if there is none.
  struct Lanes {
    bool memory = false, frames = false;
  };
  kj::Promise<void> ask();
  kj::Promise<void> askAgain(kj::Exception&& failure, Lanes lanes);
  kj::Promise<void> ask(Lanes lanes);
  Lanes wantedLanes();
  kj::Promise<void> begin(wire::ConnectResults::Accepted::Reader accepted);
  kj::Promise<void> beginFaster(wire::ConnectResults::Accepted::Reader accepted);
  void beginCalls(wire::ConnectResults::Accepted::Reader accepted);
  void beginSharing(const shm::SharedParts& parts);
  kj::Promise<FrameLinks::Link> openLink(wire::FrameOffer::Reader offer);
  kj::Promise<rpc::ByteStream> openSocket(wire::FrameOffer::Reader offer);
  void beginFrames(const FrameLinks::Link& link, std::uint32_t number, std::uint32_t rows);
  std::shared_ptr<Channel> mirroredChannel(Lane lane, rt::Doorbell& carrier, std::uint32_t rows);
  void use(std::shared_ptr<Channel> channel);
  Component& client() const;
  std::string name() const { return from_.toString() + " -> " + to_.toString(); }
  kj::Promise<void> keep();
  kj::Promise<void> comeBack(Duration pause);
  kj::Own<Heartbeat> makeHeartbeat(Duration silence);
  Duration clockError() const;
  void followClock(Time asked, wire::Peer::PingResults::Reader answer);
  void drop();

  rpc::ControlThread& control_;
  FrameLinks& frames_;
  ManagerLink& manager_;
  RequiredBase& required_;
  const Endpoint from_, to_;
  const Lane lane_;
  const Told told_;
  const Interposer interposer_;
  const std::shared_ptr<ConnectionWatch> watch_;  // of all its channels
  const std::uint64_t incarnation_;               // of this process
  const std::shared_ptr<Ledger> ledger_;
  const Duration longestSilence_;
  bool sharesMachine_ = false;  // with the peer, by a Unix socket
  std::string laneReason_;      // why it is not a faster one
  bool fasterFailed_ = false;   // the provider had agreed to one
  EventSet asked_ = 0;          // what was subscribed to when it was asked
  kj::Maybe<kj::Own<rpc::Link>> link_;
  kj::Maybe<wire::Peer::Client> peer_;
  kj::Maybe<wire::Connection::Client> connection_;
  kj::Promise<void> telling_ = kj::READY_NOW;
  Duration toldError_{0};  // of the clock, to the provider
  kj::Maybe<kj::Own<ProviderNews>> news_;
  kj::Maybe<kj::Own<rpc::ClientEnd>> end_;
  kj::Promise<std::string> framesBroken_ = kj::NEVER_DONE;
  ProcessRecord process_;  // the provider's, as it was reached
  std::uint64_t providersIncarnation_ = 0;
  Earlier earlier_;                            // as the provider told it
  ClockOffset clock_;                          // the peer's
  kj::Promise<void> keeping_ = kj::READY_NOW;  // last: cancelled first
};

}  // namespace suture
