#pragma once
// This says how long a provider may execute what the clients of one link have sent.

#include <suture/base/boot_time.h>
#include <suture/lane/provider_end.h>
#include <suture/loop/control_thread.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace suture {

/// Belongs to the control thread. Notes in `client` when this process sent the last answer to a
/// heartbeat that the client has received: that renews the leases of all connections of the link.
/// Ends the leases that have run out.
class ClientLeases {
 public:
  ClientLeases(loop::ControlThread& control, std::shared_ptr<PeerState> client)
      : control_(control), client_(std::move(client)) {}

  /// Watches the lease of `end`.
  void watch(ProviderEnd& end);
  /// Notes that the client has received the answer that says that it was sent at `sent`; 0 if the
  /// client has received none yet. Only the latest answer renews leases, from when it was sent.
  void hear(std::int64_t sent);
  /// Notes that an answer to a ping is about to be sent, and returns when, for the answer to say.
  std::int64_t answer();

 private:
  kj::Promise<void> look();

  loop::ControlThread& control_;
  const std::shared_ptr<PeerState> client_;
  std::vector<kj::Own<ProviderEnd>> ends_;
  std::int64_t answered_ = 0;                   // when the latest answer was sent, as it says
  BootTime answeredAt_{};                       // the same on the clock of the leases
  kj::Promise<void> watching_ = kj::READY_NOW;  // last: cancelled first
};

}  // namespace suture
