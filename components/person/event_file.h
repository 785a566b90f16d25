#pragma once
// The file that an input device's events come from.

#include <linux/input.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace robots {

/// /dev/input/eventN, or a FIFO that somebody writes such events to. Confined to one thread; read()
/// neither waits nor allocates, and may be called in a control loop. To open a device that is there
/// may take the kernel some milliseconds.
class EventFile {
 public:
  explicit EventFile(std::string path) : path_(std::move(path)) {}
  ~EventFile() { close(); }
  EventFile(const EventFile&) = delete;
  EventFile& operator=(const EventFile&) = delete;

  /// False if it cannot be; error() says why.
  bool open();
  bool isOpen() const { return descriptor_ >= 0; }

  /// The whole events that have come, up to 64, until the next call. What has come of another one
  /// is kept until the rest has. Closes the file if its device, or whoever wrote to it, is gone.
  std::span<const input_event> read();

  /// Why it is closed, as errno has it; 0: there is nobody to write to it.
  int error() const { return error_; }

 private:
  void close();
  bool isOfEvents() const;

  const std::string path_;
  int descriptor_ = -1;
  int error_ = 0;
  std::array<input_event, 64> events_{};
  std::size_t filled_ = 0, taken_ = 0;  // bytes of events_
};

}  // namespace robots
