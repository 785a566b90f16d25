#pragma once
// This reads the keys of a terminal, one by one.

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

struct termios;

namespace robots {

/// One thread; only the constructor allocates or waits, so it may be used in a control loop. Until
/// it is destroyed, the terminal delivers keys as they are pressed, without showing them. Ctrl-C
/// and Ctrl-Z work as always.
class Terminal {
 public:
  /// Throws suture::SetupError unless `path` is a terminal and this process is not in the
  /// background there, where the kernel would stop it.
  explicit Terminal(const std::string& path);
  /// Restores the terminal.
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Call this before the first read, and after this process was stopped for a while, during which
  /// a shell has had the terminal. It discards what has been typed up to here.
  void takeOver();
  /// Returns the keys that have come, up to 64; they are valid until the next call. Closes the
  /// terminal if it is gone.
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
