#pragma once
// This wakes a thread that waits in poll or in an event loop.

#include <kj/io.h>

#include <string>

namespace suture::loop {

/// An EventDescriptor can be read once any thread has rung it. Never blocks.
class EventDescriptor {
 public:
  /// `asked` says what it is for. Throws SetupError if this process may have no more descriptors.
  explicit EventDescriptor(const std::string& asked);

  int get() const { return descriptor_; }
  /// Any thread.
  void ring() const;
  /// Takes all rings, so that it cannot be read until the next one.
  void take() const;

 private:
  const kj::AutoCloseFd descriptor_;
};

}  // namespace suture::loop
