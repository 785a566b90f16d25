#include "coordinator/coordinator.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace robots {
namespace {

// A client whose connection is silent for the usual 2 s loses it, and with it what it has commanded
// meanwhile. It counts from its last heartbeat, which is up to 0.4 s older than the pause.
constexpr suture::Duration kCommandsMayBeLost = std::chrono::milliseconds(1500);

// A client with a shorter silence loses its connection in a shorter pause. Drives have stopped by
// then, because their permit lapses in 30 ms.
constexpr suture::Duration kShortPause = std::chrono::milliseconds(50);
// The coordinator is told of a client's end so soon after a pause.
constexpr suture::Duration kToldWithin = std::chrono::seconds(1);

}  // namespace

Coordinator::Coordinator(const CoordinatorParameters& parameters)
    : PeriodicTask({.period = parameters.period}) {}

// A stop that is released in the cycle in which it was pressed withholds one permit all the same.
void Coordinator::run() {
  const suture::Duration pause = cycles_.sinceLast();
  cycles_.begin();
  if (pause > kShortPause) pauseCountsUntil_ = suture::now() + kToldWithin;
  const bool pressMayBeLost =
      std::exchange(clientIsGone_, false) && suture::now() < pauseCountsUntil_;
  if (pause > kCommandsMayBeLost || pressMayBeLost) set(true);
  permit_ = {!pressed_ && !std::exchange(wasPressed_, false), suture::now()};
}

// Runs before the commands of a cycle. A client that came after the pause has lost no press in it.
void Coordinator::onClient(const suture::ProvidedBase&, const suture::ConnectedClient& client,
                           suture::ClientNews news) {
  if (cycles_.sinceLast() > kShortPause) newcomers_.fill(nullptr);
  const bool hasCome = news == suture::ClientNews::Connected;
  auto* const place = std::find(newcomers_.begin(), newcomers_.end(), hasCome ? nullptr : &client);
  if (place != newcomers_.end()) {
    *place = hasCome ? &client : nullptr;
  } else if (!hasCome) {
    clientIsGone_ = true;
  }
}

// The stop begins pressed, because nobody could press it until now.
void Coordinator::begin(bool isStart) {
  cycles_.begin();
  set(true, isStart);
}

// Emits the event at once, so that it does not wait for the next permit, and even if nothing
// changes, so that a client that missed one is corrected.
void Coordinator::set(bool pressed, bool isStart) {
  pressed_ = pressed;
  wasPressed_ = wasPressed_ || pressed;
  stop_.emit().stop({pressed, suture::now(), isStart});
}

}  // namespace robots
