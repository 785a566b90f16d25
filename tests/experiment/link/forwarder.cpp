#include "experiment/link/forwarder.h"

#include <poll.h>
#include <suture/base/errors.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace experiment {
namespace {

int makeTimer() {
  const int timer = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC);
  if (timer >= 0) return timer;
  throw suture::SetupError("making a timer for a link", std::strerror(errno),
                           "Raise the limit of descriptors (ulimit -n)");
}

}  // namespace

Forwarder::Forwarder(const LinkEnd& here, const LinkEnd& there, const PacketFate& fate)
    : there_(here.packets(), there.packets(), fate, 0),
      back_(there.packets(), here.packets(), fate, 1),
      timer_(makeTimer()) {}

Forwarder::~Forwarder() { close(timer_); }

void Forwarder::runUntil(int end) {
  std::array<pollfd, 4> awaited{pollfd{.fd = end, .events = POLLIN, .revents = 0},
                                {.fd = timer_, .events = POLLIN, .revents = 0},
                                {.fd = there_.from(), .events = POLLIN, .revents = 0},
                                {.fd = back_.from(), .events = POLLIN, .revents = 0}};
  while (awaited[0].revents == 0) {
    for (PacketLine* const line : {&there_, &back_}) {
      line->take();
      line->deliver(suture::now());
    }
    setTimer();
    poll(awaited.data(), awaited.size(), -1);
  }
}

/// Sets the timer for the next packet that is due; a time that has passed ends the wait at once,
/// and zero would stop the timer. What it has counted before is forgotten.
void Forwarder::setTimer() const {
  const suture::Time next = std::min(there_.next(), back_.next());
  itimerspec when{};
  if (next != suture::Time::max()) {
    const std::int64_t count = suture::toNanoseconds(next);
    when.it_value = {.tv_sec = count / 1'000'000'000, .tv_nsec = count % 1'000'000'000};
  }
  timerfd_settime(timer_, TFD_TIMER_ABSTIME, &when, nullptr);
}

}  // namespace experiment
