#pragma once
// A required interface follows its calls to their answers here.

#include <suture/base/time.h>
#include <suture/component/required/attachment.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suture {

class Calls;
struct ReplyRecord;

/// A PendingCall is a place for one call under way, and for its answer.
struct PendingCall {
  /// Limits the size of a handler of Call::then().
  static constexpr std::size_t kHandlerSize = 48;
  /// Called in the owner's thread as soon as the call is done.
  using Follower = void (*)(Calls&, PendingCall&);

  std::uint32_t number = 0;  ///< 0: free
  std::uint16_t command = 0;
  bool done = false;
  bool abandoned = false;
  bool fresh = false;   ///< answered since the last markSeen()
  bool shared = false;  ///< the result holds a counted pointer
  Errc error{};
  Time stamp{};
  std::span<std::byte> result;
  Follower follower = nullptr;  ///< null: the caller looks at the answer itself
  alignas(std::max_align_t) std::byte handler[kHandlerSize];  ///< the follower's
};

/// Belongs to the thread of the component.
class Calls final : private Attachment::User {
 public:
  explicit Calls(Attachment& attachment);
  ~Calls();
  Calls(const Calls&) = delete;
  Calls& operator=(const Calls&) = delete;

  /// Takes a place; returns nullptr if none is free.
  PendingCall* open(std::uint16_t command);
  /// Frees the place, as soon as no answer can come any more.
  void close(PendingCall& call);
  bool isDone(PendingCall& call);
  /// Returns when the call is done, after `limit`, or when its component may not wait any more.
  void waitFor(PendingCall& call, Duration limit);
  bool mayWait() const;
  /// Call it when a wait has ended at its deadline. Counts it if the provider's component may have
  /// waited for this one.
  void noteTimeout() const;
  /// Returns true if the provider will not execute it, and answers so.
  bool cancel(PendingCall& call);
  void follow(PendingCall& call, PendingCall::Follower follower);

  /// Returns true if finishFollowed() may have something to do.
  bool followedMayBeDone() const;
  /// Calls the followers of the calls that are done.
  void finishFollowed();
  /// Returns true if an answer has come since markSeen() that has not been taken.
  bool unseen();
  /// Notes that the run() which follows sees the answers that have come so far.
  void markSeen();

 private:
  void leave() override;

  void collectReplies();
  void collect(ReplyRecord& reply, std::size_t size);
  /// Frees the place of a call that is over.
  void discard(PendingCall& call);
  /// Returns what ends the calls under way, or 0 if nothing does.
  Errc end() const;

  Attachment& attachment_;
  std::vector<PendingCall> calls_;
  std::vector<std::uint64_t> results_;  // the memory of the calls' results
  std::uint32_t opened_ = 0;
  unsigned fresh_ = 0;     // how many calls are fresh
  unsigned followed_ = 0;  // how many calls have a follower
};

}  // namespace suture
