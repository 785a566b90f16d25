#include "coordinator/coordinator.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace robots {
namespace {

// A client whose connection is silent for the usual 2 s loses it, and with it what it has commanded
// meanwhile. It counts from its last heartbeat, which is up to 0.4 s older than the pause.
constexpr suture::Duration kCommandsMayBeLost = std::chrono::milliseconds(1500);

// A client that ends its connection in a shorter pause, or loses it then, loses a command as well.
// Drives have stopped by then, because their permit lapses in 30 ms.
constexpr suture::Duration kShortPause = std::chrono::milliseconds(50);
// The coordinator is told so soon after a pause of a client that was lost in it, though the thread
// that tells may go on later than this one.
constexpr suture::Duration kToldAtOnce = std::chrono::milliseconds(100);
// It is told so soon after a pause of whatever a client did in it.
constexpr suture::Duration kToldWithin = std::chrono::seconds(1);

// Returns how long a pause may be that has lost no command of a client that is told to be gone some
// time after it. One that is silent then was cut off, or stood still itself, unless the pause was
// long beside its silence: its last heartbeat is up to a fifth of that older than the pause.
suture::Duration harmlessPause(const suture::ConnectedClient& client, suture::ClientNews news) {
  if (news != suture::ClientNews::Silent) return kShortPause;
  return std::max(kShortPause, client.silence * 3 / 4);
}

}  // namespace

Coordinator::Coordinator(const CoordinatorParameters& parameters)
    : PeriodicTask({.period = parameters.period}) {
  for (const std::string& name : parameters.buttons) buttons_[name] = 0;
}

// Each press withholds one permit, even if it is released in the cycle in which it was pressed.
void Coordinator::run() {
  noticePause();
  const suture::Duration pause = cycles_.sinceLast();
  cycles_.begin();
  pauseIsNoticed_ = false;
  const bool pressMayBeLost = losesPress(pause);
  const bool nobodyCanPress = std::exchange(buttonIsGone_, false);
  if (pause > kCommandsMayBeLost || pressMayBeLost || nobodyCanPress) stopDrives(false);
  const bool withheld = permit_.press == news_.press;
  permit_ = {!news_.pressed && withheld, suture::now(), news_.press};
}

// Emits the event even if nothing changes, so that whoever asked in vain sees what holds.
void Coordinator::release(std::uint64_t press) {
  if (press != news_.press) {
    messages_.warning("not released, because it has been pressed since");
  } else if (!canBePressed()) {
    messages_.warning("not released, because a button is not connected");
  } else if (news_.pressed) {
    news_ = {false, suture::now(), false, press};
  }
  stop_.emit().stop(news_);
}

// Runs before the commands of a cycle.
void Coordinator::onClient(const suture::ProvidedBase&, const suture::ConnectedClient& client,
                           suture::ClientNews news) {
  noticePause();
  const bool hasCome = news == suture::ClientNews::Connected;
  if (const auto button = buttons_.find(client.name); button != buttons_.end()) {
    button->second += hasCome ? 1 : -1u;
    buttonIsGone_ = buttonIsGone_ || !hasCome;
  }
  if (hasCome) {
    auto* const place = std::find(newcomers_.begin(), newcomers_.end(), nullptr);
    if (place != newcomers_.end()) *place = &client;
  } else if (!forgetNewcomer(client)) {
    harmlessPause_ = std::min(harmlessPause_, harmlessPause(client, news));
  }
}

// A client that came before a pause is no newcomer any more; one that came after it has lost no
// press in it.
void Coordinator::noticePause() {
  if (cycles_.sinceLast() <= kShortPause || std::exchange(pauseIsNoticed_, true)) return;
  newcomers_.fill(nullptr);
}

bool Coordinator::losesPress(suture::Duration pause) {
  const suture::Time now = suture::now();
  if (pause > kShortPause) {
    pause_ = now - pauseEnded_ < kToldWithin ? std::max(pause, pause_) : pause;
    pauseEnded_ = now;
  }
  const suture::Duration ago = now - pauseEnded_;
  const suture::Duration harmless = std::exchange(harmlessPause_, kNobodyIsGone);
  if (harmless == kNobodyIsGone) return false;
  return ago < kToldAtOnce || (ago < kToldWithin && pause_ > harmless);
}

bool Coordinator::forgetNewcomer(const suture::ConnectedClient& client) {
  auto* const place = std::find(newcomers_.begin(), newcomers_.end(), &client);
  if (place == newcomers_.end()) return false;
  *place = nullptr;
  return true;
}

bool Coordinator::canBePressed() const {
  return std::all_of(buttons_.begin(), buttons_.end(),
                     [](const auto& button) { return button.second > 0; });
}

// The stop begins pressed, because nobody could press it until now.
void Coordinator::begin(bool isStart) {
  cycles_.begin();
  stopDrives(isStart);
}

// Emits the event at once, so that it does not wait for the next permit, and even if nothing
// changes, so that a client that missed one is corrected.
void Coordinator::stopDrives(bool isStart) {
  const suture::Time now = suture::now();
  const auto press = std::max(news_.press + 1, std::uint64_t(suture::toNanoseconds(now)));
  news_ = {true, now, isStart, press};
  stop_.emit().stop(news_);
}

}  // namespace robots
