#include <pthread.h>
#include <suture/base/errors.h>
#include <suture/base/virtual_time.h>
#include <suture/rt/thread.h>

#include <csignal>
#include <optional>
#include <system_error>
#include <utility>

namespace suture::rt {
namespace {

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

void Thread::start(const std::string& name, std::function<void()> body, Signals signals) {
  std::optional<BlockedSignals> blocked;
  if (signals == Signals::None) blocked.emplace();
  auto whole = [this, body = std::move(body)] {
    body();
    ended_.ring();
  };
  VirtualTime* const time = virtualTime();
  try {
    thread_ = time == nullptr ? std::thread(std::move(whole)) : startUnder(*time, name, whole);
  } catch (const std::system_error& error) {
    throw SetupError("starting the thread of '" + name + "'",
                     "the kernel gives this process no more threads: " + error.code().message(),
                     "Raise the limit of threads (ulimit -u, pids.max of its control group) or of "
                     "memory (ulimit -v), or let fewer components have threads");
  }
}

// The thread rings before it ends, because the kernel's way to wait for a thread does not work with
// a stepped clock.
void Thread::join() {
  ended_.wait();
  thread_.join();
}

}  // namespace suture::rt
