#pragma once
// This is the global manager as its clients see it: capabilities over one registry.

#include <kj/async.h>
#include <kj/refcount.h>
#include <kj/timer.h>
#include <kj/vector.h>
#include <suture/framing/link_server.h>
#include <suture/manager.capnp.h>
#include <suture/names/registry.h>

#include <map>
#include <memory>
#include <string>

namespace suture {

/// Belongs to the control thread; shared by all sessions. Holds the registry and the requests that
/// wait for a name.
class NameService final : public kj::Refcounted {
 public:
  /// Limits how many may wait for names at a time, of all links, of those of one peer, and of one;
  /// a further one is refused at once.
  static constexpr std::size_t kMostWaiting = 4096, kMostWaitingOfAPeer = kMostWaiting / 2,
                               kMostWaitingOfALink = 256;

  explicit NameService(kj::Timer& timer) : timer_(timer), aging_(age().eagerlyEvaluate(nullptr)) {}

  Registry& registry() { return registry_; }
  /// Returns what counts for a new link of that peer. All peers with the same proof of who they are
  /// count as one; by plain TCP nobody proves who he is.
  std::shared_ptr<Holding> holdingOf(const net::PeerIdentity& peer);
  /// Wakes the requests that wait for `name`.
  void announce(const std::string& name);
  /// Returns which limit one more that waits for the link would exceed; "" if it may.
  std::string whyNoRoom(const std::shared_ptr<Holding>& link);
  /// Call it only if there is room. Resolves when `name` is known, or after the wait, which is
  /// bounded.
  kj::Promise<void> whenKnown(const std::string& name, std::uint32_t waitMilliseconds,
                              const std::shared_ptr<Holding>& link);

 private:
  struct Waiting {
    std::string name;
    std::shared_ptr<Holding> link;
    kj::Own<kj::PromiseFulfiller<void>> arrived;
  };

  void forgetAnswered();
  /// Returns how many of those wait for which `counts(link)`.
  template <class Counts>
  std::size_t waitingOf(const Counts& counts) const;
  kj::Promise<void> age();

  kj::Timer& timer_;
  Registry registry_;
  std::map<std::string, std::weak_ptr<Holding>> peers_;  // by what they have proved
  kj::Vector<Waiting> waiting_;
  kj::Promise<void> aging_;  // last: cancelled first
};

/// Returns the bootstrap capability of the global manager on the link of `caller`: it gives a
/// session to a client that speaks its version. Adds what it refuses to `refusals`.
wire::GlobalManager::Client makeGlobalManager(kj::Own<NameService> names, net::Refusals& refusals,
                                              std::shared_ptr<framing::Caller> caller);

}  // namespace suture
