#include <suture/base/errors.h>
#include <suture/loop/event_port.h>
#include <suture/loop/failure.h>
#include <sys/epoll.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>

namespace suture::loop {
namespace {

// Work that never ends must not keep written messages or sockets waiting.
constexpr unsigned kMaxBusyTurns = 4;

kj::TimePoint toKj(Time time) {
  return kj::origin<kj::TimePoint>() + toNanoseconds(time) * kj::NANOSECONDS;
}

Time fromKj(kj::TimePoint time) {
  return fromNanoseconds((time - kj::origin<kj::TimePoint>()) / kj::NANOSECONDS);
}

kj::AutoCloseFd makeArrivals() {
  const int descriptor = epoll_create1(EPOLL_CLOEXEC);
  if (descriptor >= 0) return kj::AutoCloseFd(descriptor);
  throw SetupError("make an epoll for a stepped clock", std::strerror(errno),
                   "Raise the limit of open files (ulimit -n).");
}

}  // namespace

EventPort::FdObserver::FdObserver(EventPort& port, int descriptor, kj::uint asked)
    : kj::UnixEventPort::FdObserver(port, descriptor, asked), port_(port), descriptor_(descriptor) {
  if (!port_.steppedTimer_) return;
  epoll_event event{.events = EPOLLET, .data = {.ptr = nullptr}};
  if ((asked & OBSERVE_READ) != 0) event.events |= EPOLLIN | EPOLLRDHUP;
  if ((asked & OBSERVE_WRITE) != 0) event.events |= EPOLLOUT;
  epoll_ctl(port_.arrivals_, EPOLL_CTL_ADD, descriptor_, &event);
}

EventPort::FdObserver::~FdObserver() noexcept(false) {
  if (port_.steppedTimer_) epoll_ctl(port_.arrivals_, EPOLL_CTL_DEL, descriptor_, nullptr);
}

// KJ throws where it gets no descriptor.
EventPort::EventPort(rt::Doorbell* bell) try : bell_(bell) {
  if (virtualTime() == nullptr) return;
  steppedTimer_.emplace(toKj(now()));
  arrivals_ = makeArrivals();
} catch (const kj::Exception& error) {
  throw SetupError("start a loop of events", describe(error),
                   "Raise the limit of open files (ulimit -n).");
}

kj::Timer& EventPort::getTimer() {
  return steppedTimer_ ? *steppedTimer_ : UnixEventPort::getTimer();
}

void EventPort::flushBeforeSleep(Output& output) {
  if (std::find(outputs_.begin(), outputs_.end(), &output) == outputs_.end()) {
    outputs_.push_back(&output);
  }
}

void EventPort::forget(Output& output) { std::erase(outputs_, &output); }

bool EventPort::wait() {
  if (bringWork()) return false;
  flushAll();
  busyTurns_ = 0;
  if (loop_.isRunnable()) return UnixEventPort::poll();
  if (steppedTimer_) {
    sleepOnSteppedClock();
    return false;
  }
  return sleep();
}

bool EventPort::poll() {
  takeWork();
  flushAll();
  const bool woken = UnixEventPort::poll();
  if (steppedTimer_) steppedTimer_->advanceTo(toKj(now()));
  return woken;
}

bool EventPort::sleep() {
  if (bell_ != nullptr && !bell_->prepareToSleep()) return UnixEventPort::poll();
  const bool woken = UnixEventPort::wait();
  if (bell_ != nullptr) bell_->endSleep();
  return woken;
}

void EventPort::sleepOnSteppedClock() {
  Time deadline = Time::max();
  KJ_IF_MAYBE (next, steppedTimer_->nextEvent()) {
    deadline = fromKj(*next);
  }
  rt::Doorbell silent;
  (bell_ != nullptr ? *bell_ : silent).sleepAt(*this, deadline);
  look();
}

bool EventPort::look() {
  UnixEventPort::poll();
  steppedTimer_->advanceTo(toKj(now()));
  return loop_.isRunnable();
}

// Takes only the edges of this epoll: KJ's own epoll has them as well, for look().
bool EventPort::mayFind() {
  epoll_event events[16];
  return epoll_wait(arrivals_, events, std::size(events), 0) != 0;
}

bool EventPort::bringWork() {
  takeWork();
  return loop_.isRunnable() && ++busyTurns_ < kMaxBusyTurns;
}

void EventPort::flushAll() {
  while (!outputs_.empty()) {
    Output* const first = outputs_.front();
    outputs_.erase(outputs_.begin());
    first->flush();
  }
}

}  // namespace suture::loop
