#pragma once
// The threads of the runtime.

#include <suture/rt/doorbell.h>

#include <cstdint>
#include <functional>
#include <string>
#include <thread>

namespace suture::rt {

/// A thread that a stepped clock knows from its beginning to its end. Whoever starts it joins it.
class Thread {
 public:
  /// Which signals may interrupt it.
  enum class Signals : std::uint8_t { AsTheStarter, None };

  Thread() = default;
  /// Ends the program if the thread has not been joined, as std::thread does.
  ~Thread() = default;
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

  /// Runs `body`, which throws nothing. `name` is for a stepped clock alone. Throws
  /// std::system_error if the kernel refuses.
  void start(const std::string& name, std::function<void()> body,
             Signals signals = Signals::AsTheStarter);
  bool joinable() const { return thread_.joinable(); }
  /// Waits for its end, in any other thread.
  void join();
  /// True in the thread itself.
  bool isCurrent() const { return std::this_thread::get_id() == thread_.get_id(); }

 private:
  Doorbell ended_;
  std::thread thread_;
};

}  // namespace suture::rt
