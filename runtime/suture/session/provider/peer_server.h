#pragma once
// This is one peer's view of this process.

#include <suture/lane/lanes.h>
#include <suture/names/records.h>
#include <suture/session/provider/admission.h>
#include <suture/session/provider/client_leases.h>
#include <suture/session/provider/limits/places.h>
#include <suture/session/provider/peer_host.h>
#include <suture/session/provider/second_sockets.h>

#include <map>
#include <optional>
#include <vector>

namespace suture {

/// A PeerServer is the bootstrap capability of one link, and holds what this process keeps of the
/// session that the link carries. When the link goes, so do the connections made through it.
class PeerServer final : public wire::Peer::Server, private ServerSession {
 public:
  PeerServer(PeerHost& host, std::shared_ptr<framing::Caller> caller);
  ~PeerServer() noexcept(false);

 protected:
  kj::Promise<void> hello(HelloContext context) override;
  kj::Promise<void> connect(ConnectContext context) override;
  kj::Promise<void> describe(DescribeContext context) override;
  kj::Promise<void> ping(PingContext context) override;
  kj::Promise<void> open(OpenContext context) override;
  kj::Promise<void> explain(ExplainContext context) override;
  kj::Promise<void> socket(SocketContext context) override;
  kj::Promise<void> compared(ComparedContext context) override;

 private:
  struct ConnectAttempt;
  /// This is a connection, or what a plain client has opened.
  struct Held {
    kj::Own<ProviderEnd> end;
    std::shared_ptr<Channel> channel;
    Places::Place place;
  };

  loop::ControlThread& control() override { return host_.control_; }
  void cutOff(const std::string& why) override;

  /// Returns what `attempt()` does. If that throws SetupError, calls it once more when the process
  /// has published, and `refuse(refusal)` if it throws again.
  template <class Attempt, class Refuse>
  kj::Promise<void> whenThere(Attempt attempt, Refuse refuse);

  Endpoint endpointOf(capnp::Text::Reader component, capnp::Text::Reader interface) const;
  kj::Promise<void> decide(ProvidedBase& provided, const Endpoint& endpoint,
                           ConnectContext& context, Places::Place place);
  PeerHost::Latest latestAt(ConnectContext& context, ProviderEnd* end) const;
  /// Returns false, and refuses the request, if a later one has come first.
  bool mayTakeOver(const std::string& client, const std::string& name, ConnectContext& context);
  /// Makes the connection by the lane that was asked for, or declines it.
  kj::Promise<void> accept(const ConnectAttempt& attempt);
  /// Resolves to the end that the lane makes; nothing: the request has been refused.
  kj::Promise<kj::Maybe<AcceptedEnd>> make(LaneServer& lane, const ConnectAttempt& attempt);
  void accepted(const ConnectAttempt& attempt, AcceptedEnd accepted);
  /// Tells the caller why it cannot have that lane, and the operator if something went wrong.
  void decline(ConnectContext context, const kj::Exception& why);
  /// Returns the lane of that name in this session; nullptr: this process has no such lane.
  LaneServer* laneNamed(const std::string& name);
  kj::Promise<LaneServer*> whenLane(const std::string& name);
  kj::Promise<void> awaitSocket(LaneServer& lane, SocketContext& context);
  void keep(Held held);
  /// Returns true if there were any.
  bool forgetEnded();
  void putTasks(wire::Peer::PingResults::Builder results) const;
  void attach(ProvidedBase& provided, std::shared_ptr<Channel> channel);
  /// Returns why the caller may not have that interface.
  std::optional<Refusal> whyNotGiven(const Endpoint& endpoint);
  /// Holds in `share` what a connection to that interface needs; or returns why it may not have it.
  std::optional<Refusal> whyNoMemory(const Endpoint& endpoint, const ChannelMemory::Share& share,
                                     std::size_t bytes);
  /// Returns a call that fails. Tells also the operator of this process.
  kj::Promise<void> fail(const std::string& why);
  /// Tells the caller and, in this process, its operator.
  void refuse(const Refusal& refusal, wire::Refusal::Builder out);

  PeerHost& host_;
  const std::shared_ptr<framing::Caller> caller_;
  const Admission admission_;      // what the caller may do
  std::string bootId_;             // the peer's, as it said in hello
  std::uint64_t incarnation_ = 0;  // likewise
  std::uint64_t greeting_ = 0;     // which of all that this process has had began this session
  const std::shared_ptr<PeerState> state_ = std::make_shared<PeerState>();  // the peer's
  std::vector<std::string> watched_;  // components that it gets reports of
  Places interfaces_;                 // taken from the question on, because an answer may take long
  std::vector<Held> held_;
  bool anyEnded_ = false;  // one of `held_` had ended at the last ping
  ClientLeases leases_;
  std::map<std::string, kj::Own<LaneServer>> lanes_;
  SecondSockets sockets_;  // last: those that come go to the lanes
};

}  // namespace suture
