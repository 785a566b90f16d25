#pragma once
// Whether a peer and the task behind a connection still do their work.

#include <suture/base/boot_time.h>
#include <suture/component/task/task_activity.h>
#include <suture/loop/kj_comparisons.h>  // first
#include <suture/peer.capnp.h>

#include <kj/async.h>
#include <kj/timer.h>

#include <functional>
#include <string>
#include <utility>

namespace suture {

void toWire(const Pulse::Reading& pulse, wire::TaskPulse::Builder out);

/// Asks a peer again and again how one of its components does. Belongs to the control thread.
class Heartbeat {
 public:
  struct Bounds {
    /// How long the peer may leave a question unanswered. It counts from when the peer was last
    /// told that it had answered, and so does the peer, who then executes nothing more.
    Duration silence;
    Duration hang;  ///< how long the component's thread may be in one cycle, or late for one
  };

  Heartbeat(kj::Timer& timer, wire::Peer::Client peer, std::string component, Bounds bounds);

  /// To be set before whenLost(): called with each answer, and with when it was asked for.
  using Answered = std::function<void(Time asked, wire::Peer::PingResults::Reader answer)>;
  void onAnswer(Answered answered) { answered_ = std::move(answered); }
  /// Asks from now on. Resolves, in words for people, when a bound has passed. Call it once.
  kj::Promise<std::string> whenLost();
  /// Resolves at the first answer by which the component does not hang. Call it once.
  kj::Promise<void> whenWell();

 private:
  kj::Promise<void> look();
  void ask();
  std::string whySilent(Duration paused) const;
  void heard(Time asked, wire::Peer::PingResults::Reader told);
  bool hangs(wire::TaskPulse::Reader task, Time then);

  kj::Timer& timer_;
  wire::Peer::Client peer_;
  const std::string component_;
  const Bounds bounds_;
  const Duration interval_;
  Answered answered_;
  std::int64_t heard_ = 0;            // when the peer sent its latest answer, as it says
  BootTime told_ = BootClock::now();  // when it was last told that an answer has come
  bool asked_ = false;                // and not answered
  Time due_{};                        // of the component's thread, by the latest answer
  kj::PromiseFulfillerPair<std::string> lost_ = kj::newPromiseAndFulfiller<std::string>();
  kj::PromiseFulfillerPair<void> well_ = kj::newPromiseAndFulfiller<void>();
  kj::Promise<void> asking_ = kj::READY_NOW, looking_ = kj::READY_NOW;  // last: cancelled first
};

}  // namespace suture
