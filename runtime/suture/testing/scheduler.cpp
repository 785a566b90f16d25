#include <suture/testing/scheduler.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <utility>

namespace suture::testing_detail {
namespace {

// The time is far from zero, which means "unset", and the same in each run.
constexpr Time kBegin{std::chrono::seconds(1000)};

/// It is the calling thread, if its scheduler knows it.
thread_local ScheduledThread* current = nullptr;
/// The calling thread, and all that it starts, works for this process.
thread_local std::size_t currentProcess = 0;

/// Only a thread that stood still with its process has a deadline before that of another.
std::tuple<std::uint64_t, Time, std::size_t> orderOf(const ScheduledThread& ready) {
  return {ready.rung, ready.rung == 0 ? ready.deadline : Time{}, ready.number};
}

}  // namespace

Scheduler::Scheduler(TestClockOptions options)
    : options_(std::move(options)),
      begin_(kBegin),
      now_(toNanoseconds(kBegin)),
      chance_(options_.seed) {}

void Scheduler::adoptTest() {
  const Lock lock(mutex_);
  Thread& test = add("test");
  test.isTest = true;
  test.state = Thread::State::Runs;
  running_ = 1;
  current = &test;
}

void Scheduler::finish() {
  Lock lock(mutex_);
  threads_.erase(current->number);
  current = nullptr;
  if (threads_.empty()) return;
  const std::string left = describe();
  lock.unlock();
  report("threads are left at the end of a TestClock:" + left);
}

void Scheduler::sleep(const Sleeper& sleeper, Time deadline) {
  Lock lock(mutex_);
  Thread& self = enter();
  sleepUnlessWoken(self, sleeper, deadline, lock);
  leave(self);
}

void Scheduler::sleepAt(Sockets& sockets, const Sleeper& sleeper, Time deadline) {
  Lock lock(mutex_);
  Thread& self = enter();
  self.sockets = &sockets;
  while (sleepUnlessWoken(self, sleeper, deadline, lock)) {
    lock.unlock();
    const bool found = sockets.look();
    lock.lock();
    if (found) {
      ++turns_;
      break;
    }
    self.lookedAt = turns_;
  }
  self.sockets = nullptr;
  leave(self);
}

void Scheduler::wake(Place place) {
  const Lock lock(mutex_);
  for (const auto& [number, thread] : threads_) {
    const bool sleepsThere = thread->state == Thread::State::Sleeps && thread->place == place;
    if (sleepsThere) makeReady(*thread, ++rings_);
  }
  dispatch();
}

std::size_t Scheduler::announce(const std::string& name) {
  const Lock lock(mutex_);
  Thread& thread = add(name);
  makeReady(thread, ++rings_);
  return thread.number;
}

void Scheduler::begin(std::size_t thread) {
  Lock lock(mutex_);
  current = threads_.at(thread).get();
  currentProcess = current->process;
  dispatch();
  await(*current, lock);
}

void Scheduler::end() {
  const Lock lock(mutex_);
  threads_.erase(std::exchange(current, nullptr)->number);
  --running_;
  dispatch();
}

void Scheduler::retract(std::size_t thread) {
  const Lock lock(mutex_);
  threads_.erase(thread);
}

void Scheduler::note(Kind kind, const char* interface, const char* what, std::uint64_t number) {
  if (!options_.traced || options_.threads == Threads::Together) return;
  const Lock lock(mutex_);
  trace_.push_back({.time = now() - begin_,
                    .thread = current == nullptr ? "a thread of the test" : current->name,
                    .kind = kind,
                    .what = std::string(interface) + "." + what,
                    .number = number});
}

void Scheduler::owe(Place place) {
  const Lock lock(mutex_);
  if (current != nullptr) current->owes.push_back(place);
}

void Scheduler::settle() {
  const Lock lock(mutex_);
  if (current != nullptr) current->owes.clear();
}

// A thread rings at the end of its cycle, so another may find what it has brought before that.
void Scheduler::missedRing(const std::string& name) {
  if (options_.threads == Threads::Together) return;
  {
    const Lock lock(mutex_);
    for (const auto& [number, thread] : threads_) {
      const auto& owes = thread->owes;
      if (std::find(owes.begin(), owes.end(), current->home) != owes.end()) return;
    }
  }
  report("work waited for '" + name +
         "', which nobody had rung: it was found when something else woke that thread");
}

void Scheduler::spend(Duration duration) {
  Lock lock(mutex_);
  Thread& self = enter();
  self.deadline = now() + duration;
  sleepAs(self, lock);
  leave(self);
}

void Scheduler::hold() {
  const Lock lock(mutex_);
  ++holds_;
}

void Scheduler::release() {
  const Lock lock(mutex_);
  --holds_;
  dispatch();
}

void Scheduler::suspend(Duration duration) {
  const Lock lock(mutex_);
  suspended_.store(suspended() + duration, std::memory_order_release);
}

void Scheduler::enterProcess(std::size_t process) { currentProcess = process; }

void Scheduler::freeze(std::size_t process) {
  const Lock lock(mutex_);
  frozen_.insert(process);
}

// Makes the threads ready that have become due while time went on without them.
void Scheduler::thaw(std::size_t process) {
  const Lock lock(mutex_);
  frozen_.erase(process);
  for (const auto& [number, thread] : threads_) {
    if (thread->process != process || thread->state != Thread::State::Sleeps) continue;
    thread->lookedAt = 0;
    if (thread->deadline <= now()) makeReady(*thread, 0);
  }
  dispatch();
}

Scheduler::Thread& Scheduler::add(const std::string& name) {
  auto thread = std::make_unique<Thread>();
  thread->name = name;
  thread->process = currentProcess;
  thread->number = started_++;
  return *threads_.emplace(thread->number, std::move(thread)).first->second;
}

// A thread that the test has made itself is known while it sleeps.
Scheduler::Thread& Scheduler::enter() {
  if (current != nullptr) return *current;
  Thread& thread = add("a thread of the test");
  thread.known = false;
  return thread;
}

void Scheduler::leave(Thread& thread) {
  if (!thread.known) threads_.erase(thread.number);
}

// Returns true if it was woken only in order to look at its sockets.
bool Scheduler::sleepUnlessWoken(Thread& thread, const Sleeper& sleeper, Time deadline,
                                 Lock& lock) {
  if (sleeper.word.load(std::memory_order_seq_cst) != sleeper.asleep || deadline <= now()) {
    return false;
  }
  thread.place = thread.home = sleeper.place;
  thread.deadline = deadline;
  sleepAs(thread, lock);
  thread.place = 0;
  return std::exchange(thread.looks, false);
}

void Scheduler::sleepAs(Thread& thread, Lock& lock) {
  thread.state = Thread::State::Sleeps;
  if (thread.known) --running_;
  dispatch();
  await(thread, lock);
}

void Scheduler::await(Thread& thread, Lock& lock) {
  const auto runs = [&thread] { return thread.state == Thread::State::Runs; };
  for (;;) {
    const std::uint64_t turn = turns_;
    if (thread.wakes.wait_for(lock, options_.patience, runs)) return;
    if (turn != turns_ || namedAtTurn_ == turns_ || holds_ > 0) continue;
    namedAtTurn_ = turns_;
    const std::string all = describe();
    const bool stuck = running_ == 0;
    lock.unlock();
    if (stuck) {
      report("nothing can happen any more:" + all);
    } else {
      const std::chrono::duration<double> waited = options_.patience;
      std::fprintf(stderr, "suture: for %g s of real time no thread has slept:%s\n", waited.count(),
                   all.c_str());
    }
    lock.lock();
  }
}

void Scheduler::makeReady(Thread& thread, std::uint64_t ring) {
  thread.state = Thread::State::Ready;
  thread.rung = ring;
}

void Scheduler::grant(Thread& thread) {
  thread.state = Thread::State::Runs;
  if (thread.known) ++running_;
  if (!thread.looks) ++turns_;
  thread.wakes.notify_one();
}

void Scheduler::dispatch() {
  for (;;) {
    if (running_ > 0 && options_.threads == Threads::OneAtATime) return;
    Thread* next = nextReady();
    if (next == nullptr) {
      if (running_ > 0) return;
      next = nextToLook();
    }
    if (next == nullptr) next = nextLast();
    if (next != nullptr) {
      grant(*next);
    } else if (holds_ > 0 || !goOn()) {
      return;
    }
  }
}

Scheduler::Thread* Scheduler::nextReady() {
  std::vector<Thread*> ready;
  for (const auto& [number, thread] : threads_) {
    if (thread->isTest || isFrozen(*thread)) continue;
    if (thread->state == Thread::State::Ready) ready.push_back(thread.get());
  }
  if (ready.empty()) return nullptr;
  if (options_.seed != 0) return ready[chance_() % ready.size()];
  return *std::min_element(ready.begin(), ready.end(), [](const Thread* one, const Thread* other) {
    return orderOf(*one) < orderOf(*other);
  });
}

Scheduler::Thread* Scheduler::nextToLook() {
  for (const auto& [number, thread] : threads_) {
    const bool sleeps = thread->state == Thread::State::Sleeps && thread->sockets != nullptr;
    if (!sleeps || thread->lookedAt == turns_ || isFrozen(*thread)) continue;
    if (!thread->sockets->mayFind()) {
      thread->lookedAt = turns_;
      continue;
    }
    thread->looks = true;
    return thread.get();
  }
  return nullptr;
}

Scheduler::Thread* Scheduler::nextLast() {
  for (const auto& [number, thread] : threads_) {
    if (thread->state == Thread::State::Ready && !isFrozen(*thread)) return thread.get();
  }
  return nullptr;
}

bool Scheduler::goOn() {
  Time next = Time::max();
  for (const auto& [number, thread] : threads_) {
    if (thread->state == Thread::State::Sleeps && !isFrozen(*thread)) {
      next = std::min(next, thread->deadline);
    }
  }
  if (next == Time::max()) return false;
  now_.store(toNanoseconds(std::max(next, now())), std::memory_order_release);
  for (const auto& [number, thread] : threads_) {
    const bool due = thread->state == Thread::State::Sleeps && thread->deadline <= next;
    if (due && !isFrozen(*thread)) makeReady(*thread, 0);
  }
  return true;
}

std::string Scheduler::describe() const {
  std::string all;
  for (const auto& [number, thread] : threads_) {
    all += "\n  '" + thread->name + "' ";
    switch (thread->state) {
      case Thread::State::Runs: all += "runs"; break;
      case Thread::State::Ready: all += "is about to run"; break;
      case Thread::State::Sleeps:
        all += thread->deadline == Time::max()
                   ? "sleeps until it is rung"
                   : "sleeps for " + std::to_string((thread->deadline - now()).count()) + " ns";
    }
  }
  return all;
}

void Scheduler::report(const std::string& problem) {
  if (options_.problem) return options_.problem(problem);
  std::fprintf(stderr, "suture: %s\n", problem.c_str());
  std::abort();
}

}  // namespace suture::testing_detail
