#pragma once
// This says until when a provider may execute what a client in another process has sent.

#include <suture/base/boot_time.h>
#include <suture/component/channel/peer_state.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>

namespace suture {

/// Any thread may look. A client that hears nothing for long enough says that its provider is lost.
/// After that, the provider's end must execute no more commands of the connection, even if its
/// whole process was stopped meanwhile. So the thread that executes looks at the clock itself and
/// trusts no other thread. It is constant, since PeerState has what is heard of the client.
class Lease {
 public:
  /// Makes a lease without end: the client is in this process, or has not said how long it waits.
  Lease() = default;
  /// The client waits for `silence` before it gives its provider up; the first wait begins now.
  Lease(std::shared_ptr<const PeerState> client, Duration silence)
      : client_(std::move(client)), silence_(silence), begun_(BootClock::now()) {}

  bool limited() const { return client_ != nullptr && silence_ > Duration{0}; }
  /// Returns an end that is earlier than the client's by as much as the two clocks may drift apart.
  BootTime end() const {
    if (!limited()) return BootTime::max();
    constexpr int kDrift = 1000;
    const BootTime heard = std::max(begun_, client_->heard.load(std::memory_order_relaxed));
    return heard + silence_ - silence_ / kDrift;
  }
  bool lapsed(BootTime present) const { return limited() && present >= end(); }

 private:
  std::shared_ptr<const PeerState> client_;
  Duration silence_{0};
  BootTime begun_{};
};

}  // namespace suture
