#pragma once
// This opens something that takes long to open and serves many, such as a socket.

#include <suture/loop/kj_comparisons.h>  // first

#include <kj/async.h>

#include <memory>
#include <utility>
#include <vector>

namespace suture::loop {

/// Belongs to the control thread; outlives its promises. The first caller opens it, and all that
/// ask meanwhile get the same, or the same failure. It is opened anew when the last reference has
/// gone, or T::broken().
template <class T>
class OpenedOnce {
 public:
  using Opened = std::shared_ptr<T>;

  /// `open()` returns a promise of it.
  template <class Open>
  kj::Promise<Opened> get(const Open& open) {
    if (Opened there = opened_.lock(); there != nullptr && !there->broken()) return kj::mv(there);
    auto pair = kj::newPromiseAndFulfiller<Opened>();
    awaiting_.push_back(kj::mv(pair.fulfiller));
    if (!opening_) {
      opening_ = true;
      task_ = kj::evalNow(open)
                  .then([this](Opened&& one) { succeed(one); },
                        [this](kj::Exception&& why) { fail(why); })
                  .eagerlyEvaluate(nullptr);
    }
    return kj::mv(pair.promise);
  }

  /// Returns true if it is open, or is being opened.
  bool begun() const { return opening_ || held() != nullptr; }
  /// Returns what is open; nullptr: nothing, or the last reference has gone.
  Opened held() const { return opened_.lock(); }

 private:
  using Awaiting = std::vector<kj::Own<kj::PromiseFulfiller<Opened>>>;

  Awaiting settle() {
    opening_ = false;
    return std::exchange(awaiting_, {});
  }
  void succeed(const Opened& one) {
    opened_ = one;
    for (auto& asker : settle()) asker->fulfill(Opened(one));
  }
  void fail(const kj::Exception& why) {
    for (auto& asker : settle()) asker->reject(kj::cp(why));
  }

  std::weak_ptr<T> opened_;
  bool opening_ = false;
  Awaiting awaiting_;
  kj::Promise<void> task_ = kj::READY_NOW;  // last: cancelled first
};

}  // namespace suture::loop
