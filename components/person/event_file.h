#pragma once
// This is the file from which an input device's events come.

#include <linux/input.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace robots {

/// One thread; read() neither waits nor allocates, and may be called in a control loop. The file is
/// /dev/input/eventN, or a FIFO into which somebody writes such events. Opening a device that is
/// there may take the kernel some milliseconds.
class EventFile {
 public:
  explicit EventFile(std::string path) : path_(std::move(path)) {}
  ~EventFile() { close(); }
  EventFile(const EventFile&) = delete;
  EventFile& operator=(const EventFile&) = delete;

  /// Opens the file. Returns false if it cannot be opened; error() says why.
  bool open();
  bool isOpen() const { return descriptor_ >= 0; }

  /// Returns the whole events that have come, up to 64; they are valid until the next call. The
  /// beginning of another event is kept until its rest has come. Closes the file if its device, or
  /// the process that wrote to it, is gone.
  std::span<const input_event> read();

  /// Returns the errno that says why it is closed; 0 if no process writes to it.
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
