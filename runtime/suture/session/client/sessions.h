#pragma once
// These are the sessions of this process with the peers whose components it uses.

#include <suture/loop/opened_once.h>
#include <suture/session/client/peer_session.h>

#include <map>
#include <memory>
#include <string>

namespace suture {

/// Belongs to the control thread; outlives what it opens. Its end rejects what was asked, since an
/// attempt may live on whose asker has given up.
class Sessions {
 public:
  Sessions(loop::ControlThread& control, ManagerLink& manager, const Lanes& lanes,
           SessionIdentity self)
      : control_(control), manager_(manager), lanes_(lanes), self_(std::move(self)) {}

  /// Resolves to the session with `process`: the one that exists, or a new one. Then it waits for
  /// the process no longer than `patience`, and for each of its answers no longer than `limit`.
  /// Rejects with the reason. The session ends when the last reference to it is gone.
  kj::Promise<std::shared_ptr<PeerSession>> open(const std::string& process, Duration patience,
                                                 Duration limit);

  loop::ControlThread& control() { return control_; }
  /// Returns what a session may carry a connection by, the fastest first.
  const Lanes& lanes() const { return lanes_; }
  /// Returns true if there is one, or one is being opened, be it that nobody waits for it any more.
  bool any() const;

 private:
  struct Known {
    loop::OpenedOnce<PeerSession> session;
    Time until{};  // when the attempt under way ends
  };

  kj::Promise<std::shared_ptr<PeerSession>> dial(const std::string& process, Duration patience,
                                                 Duration limit);

  loop::ControlThread& control_;
  ManagerLink& manager_;
  const Lanes& lanes_;
  const SessionIdentity self_;
  std::map<std::string, Known> known_;  // by the peer's process
  kj::Canceler asking_;                 // last: no attempt sees the others gone
};

/// Says what to do about a peer that is there and does not answer.
std::string noAnswerOf(const std::string& process);

}  // namespace suture
