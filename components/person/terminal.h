#pragma once
// The keys of a terminal, one by one.

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

struct termios;

namespace robots {

/// Has a terminal hand over keys as they are pressed, without showing them, until it is destroyed.
/// Ctrl-C and Ctrl-Z work as always. Confined to one thread; but for the constructor nothing
/// allocates or waits, and it may be used in a control loop.
class Terminal {
 public:
  /// Throws suture::SetupError unless `path` is a terminal, and this process is not one of those in
  /// the background there, which the kernel would stop.
  explicit Terminal(const std::string& path);
  /// It is as it was before.
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Before the first read, and after this process was stopped for a while, when a shell has had
  /// the terminal: what has been typed up to here does not count.
  void takeOver();
  /// The keys that have come, up to 64, until the next call. Closes the terminal if that is gone.
  std::span<const char> read();
  bool isOpen() const { return descriptor_ >= 0; }

 private:
  bool isInForeground() const;
  void apply(const termios& mode) const;
  void close();

  int descriptor_;
  std::unique_ptr<termios> before_, own_;
  std::array<char, 64> keys_{};
};

}  // namespace robots
