#pragma once
// The global manager as its clients see it: capabilities over one registry.

#include <kj/async.h>
#include <kj/refcount.h>
#include <kj/timer.h>
#include <kj/vector.h>
#include <suture/framing/link_server.h>
#include <suture/manager.capnp.h>
#include <suture/names/registry.h>

#include <memory>
#include <string>

namespace suture {

/// The registry and those who wait for a name. Belongs to the control thread; shared by all
/// sessions.
class NameService final : public kj::Refcounted {
 public:
  /// How many may wait for names at a time; who comes then is refused at once.
  static constexpr std::size_t kMostWaiting = 4096;

  explicit NameService(kj::Timer& timer) : timer_(timer), aging_(age().eagerlyEvaluate(nullptr)) {}

  Registry& registry() { return registry_; }
  /// Wakes who waits for `name`.
  void announce(const std::string& name);
  /// True if one more may wait.
  bool hasRoom();
  /// Resolves when `name` is known, or after the wait, which is bounded. Only if there is room.
  kj::Promise<void> whenKnown(const std::string& name, std::uint32_t waitMilliseconds);

 private:
  struct Waiting {
    std::string name;
    kj::Own<kj::PromiseFulfiller<void>> arrived;
  };

  void forgetAnswered();
  kj::Promise<void> age();

  kj::Timer& timer_;
  Registry registry_;
  kj::Vector<Waiting> waiting_;
  kj::Promise<void> aging_;  // last: cancelled first
};

/// The bootstrap capability of the global manager on the link of `caller`: hands a session to who
/// speaks its version. What it refuses is added to `refusals`.
wire::GlobalManager::Client makeGlobalManager(kj::Own<NameService> names, rpc::Refusals& refusals,
                                              std::shared_ptr<rpc::Caller> caller);

}  // namespace suture
