#pragma once
// This asks if a peer and the tasks behind a session's connections still work.

#include <suture/base/boot_time.h>
#include <suture/loop/kj_comparisons.h>  // first
#include <suture/peer.capnp.h>

#include <kj/async.h>
#include <kj/function.h>
#include <kj/timer.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace suture {

/// Belongs to the control thread, and outlives its watches. Asks a peer again and again if it and
/// those of its components that are watched still work. All watches check the same answers, each by
/// its own bounds; it asks as often as the strictest needs.
class Heartbeat {
 public:
  struct Bounds {
    /// Says how long the peer may leave a question unanswered. It counts from when the peer was
    /// last told that it had answered. The peer counts likewise, and then executes nothing more.
    Duration silence;
    Duration hang;  ///< how long the component's thread may be in one cycle, or late for one
  };
  /// A silence that never ends, for a caller that limits its wait for an answer itself.
  static constexpr Duration kEver = Duration::max();

  /// Called once, with the reason in words for people. It must not end the watch itself.
  using Lost = kj::Function<void(std::string why)>;

  class Watch {
   public:
    Watch(Heartbeat& heartbeat, std::string component, Bounds bounds, Lost lost);
    ~Watch();
    KJ_DISALLOW_COPY(Watch);

    /// Resolves at the next answer by which the component does not hang. Call it once.
    kj::Promise<void> whenItWorks();

   private:
    friend class Heartbeat;
    BootTime silentAt() const;
    void lose(std::string why);
    void look(BootTime present, BootTime begun);
    void heard(wire::TaskActivity::Reader task, Time then);
    bool hangs(wire::TaskActivity::Reader task, Time then);

    Heartbeat& heartbeat_;
    const std::string component_;
    const Bounds bounds_;
    const BootTime begun_ = BootClock::now();
    std::size_t place_ = 0;  // the component's among the watched ones
    Time due_{};             // when the component's thread is due, by the latest answer
    bool lost_ = false;
    Lost tellLost_;
    kj::Maybe<kj::Own<kj::PromiseFulfiller<void>>> well_;  // null: no caller waits for that
  };

  Heartbeat(kj::Timer& timer, wire::Peer::Client peer) : timer_(timer), peer_(kj::mv(peer)) {}

  /// Watches a component of the peer, from the next answer on. Calls `lost` when a bound has
  /// passed, or the peer is gone, perhaps before this returns.
  kj::Own<Watch> watch(std::string component, Bounds bounds, Lost lost);
  /// Ends all watches for this reason, because the peer is gone.
  void end(const std::string& why);

  /// Set it before the first watch. It is called with each answer, and with when that was asked
  /// for.
  using Answered = std::function<void(Time asked, wire::Peer::PingResults::Reader answer)>;
  void onAnswer(Answered answered) { answered_ = std::move(answered); }

  /// An answer has taken this long. A loss to silence tells if its bound leaves the fastest no
  /// time.
  void noteRoundTrip(Duration took) { fastest_ = std::min(fastest_, took); }

  /// Returns true if a watch has been lost to silence, no answer has come since, and no other watch
  /// bears the silence still.
  bool silent() const;

 private:
  Duration interval() const;
  kj::Promise<void> look();
  std::string whyTooShort(Duration silence) const;
  void ask();
  std::vector<std::string> components() const;
  void name();
  void heard(Time asked, wire::Peer::PingResults::Reader told);

  kj::Timer& timer_;
  wire::Peer::Client peer_;
  Answered answered_;
  std::vector<Watch*> watches_;
  std::vector<std::string> named_;    // what the peer reports on, in this order
  std::string gone_;                  // why the peer is gone; "" while it is there
  bool renamed_ = false;              // the peer must be told of the new names
  bool lostOne_ = false;              // to silence, since the latest answer
  Duration fastest_ = kEver;          // the answer that took the least time
  std::int64_t heard_ = 0;            // when the peer sent its latest answer, by its own clock
  BootTime told_ = BootClock::now();  // when it was last told that an answer has come
  bool asked_ = false;                // a question is under way
  kj::Promise<void> asking_ = kj::READY_NOW, looking_ = kj::READY_NOW;  // last: cancelled first
};

}  // namespace suture
