#include <suture/loop/control_thread.h>
#include <suture/rt/scheduling.h>
#include <suture/rt/standard_error.h>

#include <pthread.h>

#include <algorithm>
#include <optional>

namespace suture::loop {

ControlThread::Loop::Loop(ControlThread& thread)
    : EventPort(&thread.doorbell()),
      owner(thread),
      rung(*this, thread.bell_.descriptor(), FdObserver::OBSERVE_READ),
      tasks(*this) {}

void ControlThread::Loop::runUntilStopped() {
  auto pair = kj::newPromiseAndFulfiller<void>();
  stop = kj::mv(pair.fulfiller);
  pair.promise.wait(scope());
}

void ControlThread::Loop::takeWork() {
  if (owner.doorbell().takeRing() == rt::RungFor::Nothing) return requireRing();
  owner.runPosted();
  owner.runPumps();
}

// On a stepped clock, this is called when a timer or a socket wakes this thread. If work for it
// waits then, somebody has not rung.
void ControlThread::Loop::requireRing() {
  VirtualTime* const time = virtualTime();
  if (time == nullptr || !isIdle()) return;
  const bool posted = owner.anyPosted_.load(std::memory_order_acquire);
  owner.runPosted();
  owner.runPumps();
  if (posted || !isIdle()) time->missedRing("control");
}

void ControlThread::Loop::report(const kj::Exception& exception) {
  rt::printUnlessFull("suture: a background task failed: " + describe(exception));
}

ControlThread::ControlThread() {
  thread_.start(
      "control", [this] { serve(); }, rt::Thread::Signals::None);
  started_.wait();
  if (!whyNot_) return;
  thread_.join();
  std::rethrow_exception(whyNot_);
}

void ControlThread::serve() {
  pthread_setname_np(pthread_self(), "suture-control");
  rt::askForSlice(rt::kServiceSlice);
  std::optional<Loop> loop;
  try {
    loop.emplace(*this);
  } catch (...) {
    whyNot_ = std::current_exception();
    return started_.ring();
  }
  loop_ = &*loop;
  started_.ring();
  loop->runUntilStopped();
  std::lock_guard lock(mutex_);
  posted_.clear();
}

ControlThread::~ControlThread() noexcept {
  post([this] { loop_->stop->fulfill(); });
  thread_.join();
}

void ControlThread::post(kj::Function<void()> work) {
  // Ring under the lock, so that the destructor's own post comes after every other post has left.
  std::lock_guard lock(mutex_);
  posted_.push_back(kj::mv(work));
  anyPosted_.store(true, std::memory_order_release);
  doorbell().ring();
}

void ControlThread::requireOther() const {
  if (isCurrent()) throw std::logic_error("ControlThread::run() would wait for itself");
}

void ControlThread::add(Pump& pump) { pumps_.push_back(&pump); }

void ControlThread::remove(Pump& pump) {
  // Leave a hole instead of erasing: the caller may be in the middle of runPumps().
  std::replace(pumps_.begin(), pumps_.end(), &pump, static_cast<Pump*>(nullptr));
}

void ControlThread::runPosted() {
  if (!anyPosted_.load(std::memory_order_acquire)) return;
  std::vector<kj::Function<void()>> work;
  {
    std::lock_guard lock(mutex_);
    work.swap(posted_);
    anyPosted_.store(false, std::memory_order_relaxed);
  }
  for (auto& item : work) {
    KJ_IF_MAYBE (exception, kj::runCatchingExceptions([&] { item(); })) {
      loop_->report(*exception);
    }
  }
}

void ControlThread::runPumps() {
  for (std::size_t i = 0; i < pumps_.size(); ++i) {
    if (pumps_[i] != nullptr) pumps_[i]->pump();
  }
  std::erase(pumps_, nullptr);
}

}  // namespace suture::loop
