#include <pthread.h>
#include <sched.h>
#include <suture/base/errors.h>
#include <suture/base/virtual_time.h>
#include <suture/rt/thread.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstring>
#include <utility>

namespace suture::rt {
namespace {

void pin(const std::string& name, int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(cpu, &set);
  if (const int error = pthread_setaffinity_np(pthread_self(), sizeof(set), &set); error != 0) {
    throw SetupError("cannot pin the thread of '" + name + "' to processor " + std::to_string(cpu),
                     std::strerror(error), "Choose a processor that this process may use (nproc)");
  }
}

void makeFifo(const std::string& name, int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
      error != 0) {
    throw SetupError(
        "cannot give the thread of '" + name + "' SCHED_FIFO priority " + std::to_string(priority),
        std::strerror(error),
        "Grant real-time priorities (ulimit -r, CAP_SYS_NICE) or leave it out");
  }
}

/// The kernel's struct sched_attr; glibc 2.36 has none.
struct SchedulingAttributes {
  std::uint32_t size = sizeof(SchedulingAttributes);
  std::uint32_t policy = SCHED_OTHER;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime = 0, deadline = 0, period = 0;
};

/// While it lives, the calling thread starts threads that no signal interrupts.
class BlockedSignals {
 public:
  BlockedSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t before_;
};

std::thread startUnder(VirtualTime& time, const std::string& name, std::function<void()> body) {
  const std::size_t number = time.announce(name);
  try {
    return std::thread([&time, number, body = std::move(body)] {
      time.begin(number);
      body();
      time.end();
    });
  } catch (...) {
    time.retract(number);
    throw;
  }
}

}  // namespace

void askForSlice(Duration slice) {
  if (sched_getscheduler(0) != SCHED_OTHER) return;
  SchedulingAttributes attributes;
  attributes.nice = getpriority(PRIO_PROCESS, 0);
  attributes.runtime = static_cast<std::uint64_t>(slice.count());
  syscall(SYS_sched_setattr, 0, &attributes, 0);
}

void configureThisThread(const std::string& name, const Scheduling& scheduling) {
  pthread_setname_np(pthread_self(), name.substr(0, 15).c_str());
  prctl(PR_SET_TIMERSLACK, 1UL);  // ns; else the kernel may end every timed sleep 50 us late
  if (scheduling.cpu) pin(name, *scheduling.cpu);
  if (scheduling.fifoPriority) {
    makeFifo(name, *scheduling.fifoPriority);
  } else {
    askForSlice(kTaskSlice);
  }
}

void Thread::start(const std::string& name, std::function<void()> body, Signals signals) {
  std::optional<BlockedSignals> blocked;
  if (signals == Signals::None) blocked.emplace();
  auto whole = [this, body = std::move(body)] {
    body();
    ended_.ring();
  };
  VirtualTime* const time = virtualTime();
  thread_ = time == nullptr ? std::thread(std::move(whole)) : startUnder(*time, name, whole);
}

// The kernel lets nobody wait for a thread on a stepped clock, so its end is rung first.
void Thread::join() {
  ended_.wait();
  thread_.join();
}

}  // namespace suture::rt
