#pragma once
// This is something that happens once, which promises wait for.

#include <kj/async.h>

#include <utility>

namespace suture::loop {

/// Belongs to the thread of an event loop; outlives its promises.
class Milestone {
 public:
  Milestone() : Milestone(kj::newPromiseAndFulfiller<void>()) {}

  /// Says that it has happened. May be called again.
  void reach() { fulfiller_->fulfill(); }
  /// Resolves when it happens, or at once if it has.
  kj::Promise<void> reached() { return fork_.addBranch(); }

 private:
  explicit Milestone(kj::PromiseFulfillerPair<void> pair)
      : fulfiller_(kj::mv(pair.fulfiller)), fork_(pair.promise.fork()) {}

  kj::Own<kj::PromiseFulfiller<void>> fulfiller_;
  kj::ForkedPromise<void> fork_;
};

}  // namespace suture::loop
