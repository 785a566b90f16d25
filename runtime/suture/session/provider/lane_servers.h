#pragma once
// These are the lanes of one session, in the provider's process.

#include <suture/session/provider/shared/shared_by_sessions.h>

#include <map>
#include <string>

namespace suture {

/// Belongs to the control thread. Makes what a lane keeps for a session as soon as the peer names
/// it.
class LaneServers {
 public:
  /// Both outlive it.
  LaneServers(SharedBySessions& shared, ServerSession& session)
      : shared_(shared), session_(session) {}

  /// Resolves to the lane of that name. Waits until the process has published, since it may add
  /// lanes until then, and rejects if it has none.
  kj::Promise<LaneServer*> named(const std::string& name);

 private:
  /// Returns nullptr: this process has no such lane yet.
  LaneServer* find(const std::string& name);

  SharedBySessions& shared_;
  ServerSession& session_;
  std::map<std::string, kj::Own<LaneServer>> lanes_;
};

}  // namespace suture
