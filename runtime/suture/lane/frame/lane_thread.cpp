#include <suture/base/errors.h>
#include <suture/lane/frame/lane_thread.h>
#include <suture/rt/scheduling.h>

#include <poll.h>
#include <sys/epoll.h>

#include <cerrno>
#include <cstring>
#include <iterator>

namespace suture::frame {
namespace {

// Limits what one look brings; the rest comes with the next.
constexpr int kArrivals = 64;

kj::AutoCloseFd makePoll() {
  const int descriptor = epoll_create1(EPOLL_CLOEXEC);
  if (descriptor >= 0) return kj::AutoCloseFd(descriptor);
  throw SetupError("make an epoll for the thread of frames", std::strerror(errno),
                   "Raise the limit of open files (ulimit -n).");
}

}  // namespace

LaneThread::LaneThread() : poll_(makePoll()) {
  epoll_event event{.events = EPOLLIN | EPOLLET, .data = {.ptr = nullptr}};
  if (epoll_ctl(poll_, EPOLL_CTL_ADD, bell_.descriptor(), &event) == 0) return;
  throw SetupError("watch the bell of the thread of frames", std::strerror(errno),
                   "Raise the limit of what a user watches (fs.epoll.max_user_watches)");
}

void LaneThread::stop() {
  stopping_ = true;
  bell_.doorbell().ring();
  if (thread_.joinable()) thread_.join();
  carried_.clear();
}

void LaneThread::add(std::shared_ptr<FrameLink> link) {
  {
    const std::lock_guard lock(mutex_);
    added_.push_back(std::move(link));
    anyAdded_ = true;
    if (!thread_.joinable()) {
      thread_.start(
          "lane", [this] { loop(); }, rt::Thread::Signals::None);
    }
  }
  bell_.doorbell().ring();
}

void LaneThread::loop() {
  pthread_setname_np(pthread_self(), "suture-lane");
  rt::askForSlice(rt::kServiceSlice);
  // Take a ring before looking for a stop: the ring of a later stop() then ends the sleep.
  for (;;) {
    const bool rung = bell_.doorbell().takeRing() != rt::RungFor::Nothing;
    if (stopping_) break;
    if (!rung) requireRing();
    takeOver();
    turnAll();
    sleep();
  }
  for (const Carried& one : carried_) one.link->end();
}

// On a stepped clock, this is called when the thread looks by itself from time to time, or when
// something has arrived. If something to send waits for it then, somebody has not rung.
void LaneThread::requireRing() {
  VirtualTime* const time = virtualTime();
  if (time == nullptr) return;
  for (const Carried& one : carried_) {
    if (!one.full && one.link->gives()) return time->missedRing("lane");
  }
}

void LaneThread::takeOver() {
  if (!anyAdded_.exchange(false)) return;
  const std::lock_guard lock(mutex_);
  for (auto& one : added_) {
    carried_.push_back({std::move(one)});
    watch(carried_.back(), EPOLL_CTL_ADD);
  }
  added_.clear();
}

// Breaks a link of which nothing would be heard.
void LaneThread::watch(const Carried& carried, int operation) {
  const std::uint32_t room = carried.full ? std::uint32_t{EPOLLOUT} : 0;
  epoll_event event{.events = EPOLLIN | room, .data = {.ptr = carried.link.get()}};
  if (epoll_ctl(poll_, operation, carried.link->descriptor(), &event) == 0) return;
  if (operation == EPOLL_CTL_DEL) return;
  carried.link->breakOff(std::string("the kernel does not watch its socket: ") +
                         std::strerror(errno));
  bell_.doorbell().ring();
}

void LaneThread::turnAll() {
  for (Carried& one : carried_) {
    one.link->turn();
    if (one.link->hasMore()) bell_.doorbell().ring();
    if (one.link->isFull() == one.full) continue;
    one.full = !one.full;
    watch(one, EPOLL_CTL_MOD);
  }
  std::erase_if(carried_, [this](const Carried& one) { return isDone(one); });
}

// A thread that holds an empty link is about to let a connection join. Take a link out of the poll
// before its end: closing the socket is not enough while another descriptor of it is open.
bool LaneThread::isDone(const Carried& carried) {
  const bool unused = carried.link.use_count() == 1 && carried.link->endIfEmpty();
  if (!unused && !carried.link->broken()) return false;
  watch(carried, EPOLL_CTL_DEL);
  carried.link->end();
  return true;
}

void LaneThread::sleep() {
  if (virtualTime() != nullptr) {
    const Time due = carried_.empty() ? Time::max() : now() + rt::Doorbell::kLookAgain;
    bell_.doorbell().sleepAt(*this, due);
    takeArrivals(0);
    return;
  }
  const bool maySleep = bell_.doorbell().prepareToSleep();
  takeArrivals(maySleep ? -1 : 0);
}

bool LaneThread::look() { return takeArrivals(0) > 0; }

bool LaneThread::mayFind() {
  pollfd arrivals{.fd = poll_, .events = POLLIN, .revents = 0};
  return poll(&arrivals, 1, 0) != 0;
}

int LaneThread::takeArrivals(int timeout) {
  epoll_event events[kArrivals];
  const int count = epoll_wait(poll_, events, kArrivals, timeout);
  bell_.doorbell().endSleep();
  for (int i = 0; i < count; ++i) {
    auto* const link = static_cast<FrameLink*>(events[i].data.ptr);
    if (link != nullptr && (events[i].events & ~std::uint32_t{EPOLLOUT}) != 0) link->arrived();
  }
  return count;
}

}  // namespace suture::frame
