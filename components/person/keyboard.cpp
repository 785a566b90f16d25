#include "person/keyboard.h"

#include "parameters/valid_time.h"
#include "surgeon/pause.h"

namespace robots {
namespace {

// A hand must not move on for longer after a key that was released.
constexpr suture::Duration kLongestHold = std::chrono::seconds(2);

}  // namespace

Keyboard::Keyboard(const KeyboardParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      held_(master_, teleoperation_, hand_, parameters.opening),
      terminal_(parameters.terminal),
      keys_({parameters.speed, parameters.turning_speed, parameters.hold}) {
  requireTime("hold", parameters.hold, {.longest = kLongestHold});
}

void Keyboard::onStart() {
  messages_.status(KeyMotion::kHelp);
  pedalPort_.emit().clutch(pedals_.clutch);
  pedalPort_.emit().camera(pedals_.camera);
  pedalPort_.emit().coagulation(pedals_.coagulation);
}

void Keyboard::run() {
  const suture::Time now = suture::now();
  readKeys(now);
  tellPedals(now);
  held_.move(keys_.at(now));
}

// Discards the keys that waited while the task did not run, because they were not meant for the
// present situation.
void Keyboard::readKeys(suture::Time now) {
  if (!terminal_.isOpen()) return;
  if (cycles_.missed(kLongestPause)) {
    terminal_.takeOver();
    keys_.stop();
  }
  for (const char key : terminal_.read()) keys_.take(key, now);
  if (terminal_.isOpen()) return;
  keys_.stop();
  messages_.error("the terminal is gone: its keys move the hand no more");
}

void Keyboard::tellPedals(suture::Time now) {
  if (keys_.clutch() != pedals_.clutch) pedalPort_.emit().clutch(keys_.clutch());
  pedals_.clutch = keys_.clutch();
  if (terminal_.isOpen()) pedals_.stamp = now;
}

}  // namespace robots
