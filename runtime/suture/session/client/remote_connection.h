#pragma once
// This connects one required interface of this process to a provided one of another.

#include <suture/component/channel/counts/ledger.h>
#include <suture/peer.capnp.h>
#include <suture/session/client/notices_receiver.h>
#include <suture/session/client/sessions.h>
#include <suture/session/planned_connection.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace suture {

/// Belongs to the control thread; outlives its promises. It is an entry in the session with the
/// provider's process. When the session ends, or only this is lost, the required interface is Lost
/// at once, and the connection is made anew, with back-off, for as long as this lives.
class RemoteConnection {
 public:
  /// The control thread calls these with news of the connection.
  struct Listener {
    /// Takes each channel, when the connection has been made or made anew.
    std::function<void(std::shared_ptr<Channel>)> made;
    /// Gets the channel's name and the reason in words, before the channel is lost.
    std::function<void(const std::string& channel, std::string why)> lost;
    /// Gets the reason in words why a lost one cannot be made anew yet, if somebody has to know it,
    /// and another one when that changes.
    std::function<void(const std::string& channel, std::string why)> notBack;
    /// Gets the reason in words why a lane that should carry it does not, when that changes. It
    /// travels by a slower one, or is refused.
    std::function<void(const std::string& channel, const std::string& lane, std::string why)>
        failed;
  };

  /// Both ends of `planned` name their processes. `ledger` has the sums of the connection's name.
  RemoteConnection(Sessions& sessions, PlannedConnection planned, Listener listener,
                   std::shared_ptr<Ledger> ledger);
  ~RemoteConnection() noexcept(false);

  /// Connects, and waits for the other process and its component as long as its options say.
  /// Rejects with the reason.
  kj::Promise<void> open();
  /// Takes the connection down for good; the client does not count that as a loss.
  void end();

 private:
  using Results = capnp::Response<wire::ConnectResults>;

  /// `limit` says how long the peer may take for each answer.
  kj::Promise<void> connect(Duration patience, Duration limit);
  template <class T>
  kj::Promise<T> inTime(Duration limit, kj::Promise<T> answer);
  kj::Promise<void> introduce();
  kj::Exception whyNotIntroduced(const std::string& why) const;
  kj::Promise<void> requireClocksThatCanTell();
  /// Returns the place of the first lane that may carry it. Throws if there is none of the name
  /// asked for.
  std::size_t firstLane() const;
  kj::Promise<void> askNext(std::size_t lane);
  /// Asks for the connection on that lane or, if it cannot be had, on a later one.
  kj::Promise<void> ask(std::size_t lane);
  /// Resolves to the reason if that lane cannot be had; rejects if none can, or if one that was had
  /// before may be had again soon.
  kj::Promise<kj::Maybe<std::string>> attempt(LaneClient& lane, const char* name);
  kj::Promise<kj::Maybe<std::string>> request(LaneAttempt& attempt, const char* name);
  void fillIn(wire::ConnectRequest::Builder request, const char* lane);
  kj::Promise<kj::Maybe<std::string>> begin(LaneAttempt& attempt, const char* lane,
                                            Results&& results);
  /// Tells why that lane does not carry it although it should, and returns the reason.
  std::string failed(const char* lane, std::string why);
  void use(OpenedEnd opened, wire::ConnectResults::Accepted::Reader accepted);
  OutgoingConnection outgoing() const;
  std::string name() const { return connectionName(planned_.from, planned_.to); }
  void keep();
  void letGo();
  void lose(std::string why);
  /// Begins an attempt at `next`; after those that fail, waits longer for the next one's answers.
  kj::Promise<void> comeBack(Time next, Duration pause, Duration limit);
  void drop();
  void tellWhyNotBack(const kj::Exception& failure);
  bool comesBack() const { return comingBack_ != nullptr; }

  Sessions& sessions_;
  const PlannedConnection planned_;
  const Listener listener_;
  const std::shared_ptr<Ledger> ledger_;
  const Duration longestSilence_;
  const std::size_t firstLane_;
  Duration limit_{0};       // for each answer, in this attempt
  std::string laneReason_;  // why it is not a faster lane
  std::string whyNotBack_;  // as it was told since the last loss
  // failed() has told this last of each lane that has not carried it since.
  std::map<std::string, std::string> whyFailed_;
  EventSet asked_ = 0;  // the events that were subscribed to when it was asked
  std::shared_ptr<PeerSession> session_;
  kj::Maybe<wire::Connection::Client> connection_;
  kj::Maybe<kj::Own<ProviderNews>> news_;
  kj::Maybe<kj::Own<ClientEnd>> end_;
  kj::Maybe<kj::Own<Heartbeat::Watch>> watching_;
  // These are null as long as nothing was lost, since a promise of KJ takes half a KiB. They are
  // last, so they are cancelled first.
  kj::Maybe<kj::Promise<void>> comingBack_, losing_;
};

}  // namespace suture
