#pragma once
// This starts the threads of the runtime.

#include <suture/rt/doorbell.h>

#include <cstdint>
#include <functional>
#include <string>
#include <thread>

namespace suture::rt {

/// This is a thread that a stepped clock knows from its beginning to its end. Its starter must join
/// it.
class Thread {
 public:
  /// Says which signals may interrupt it.
  enum class Signals : std::uint8_t { AsTheStarter, None };

  Thread() = default;
  /// Ends the program if the thread has not been joined, as std::thread does.
  ~Thread() = default;
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

  /// Runs `body`, which must not throw. `name` is for a stepped clock and for messages.
  /// Throws SetupError if the kernel refuses.
  void start(const std::string& name, std::function<void()> body,
             Signals signals = Signals::AsTheStarter);
  bool joinable() const { return thread_.joinable(); }
  /// Any other thread. Waits until it has ended.
  void join();
  /// Returns true in the thread itself.
  bool isCurrent() const { return std::this_thread::get_id() == thread_.get_id(); }

 private:
  Doorbell ended_;
  std::thread thread_;
};

}  // namespace suture::rt
