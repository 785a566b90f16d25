#pragma once
// How long a provider may execute what the clients of one link have sent.

#include <suture/base/boot_time.h>
#include <suture/lane/provider_end.h>
#include <suture/loop/control_thread.h>

#include <cstdint>
#include <vector>

namespace suture {

/// Renews the leases of a link's connections by the heartbeats that its client answers, and ends
/// those that have run out. Belongs to the control thread.
class ClientLeases {
 public:
  /// Bounds what a client may say, since sums with it have to fit.
  static constexpr Duration kLongestSilence = std::chrono::hours(24 * 365);

  explicit ClientLeases(rpc::ControlThread& control) : control_(control) {}

  /// The client of `end` gives its provider up after `silence`, at most kLongestSilence; 0: never.
  /// Counts from now.
  void grant(rpc::ProviderEnd& end, Duration silence);
  /// The client has the answer to a ping which says that it was sent at `sent`; 0: it has none.
  void hear(std::int64_t sent);
  /// An answer to a ping is about to be sent: when, as it says.
  std::int64_t answer();

 private:
  kj::Promise<void> watch();

  rpc::ControlThread& control_;
  std::vector<kj::Own<rpc::ProviderEnd>> ends_;
  std::int64_t answered_ = 0;                   // when the latest answer was sent, as it says
  BootTime answeredAt_{};                       // and on the clock of the leases
  kj::Promise<void> watching_ = kj::READY_NOW;  // last: cancelled first
};

}  // namespace suture
