#pragma once
// This is a FIFO in place of an input device.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <string>
#include <vector>

#include "support/temporary_directory.h"

namespace robots::test {

/// Makes the FIFO, to which nothing is written until plugIn().
class Fifo {
 public:
  Fifo() { EXPECT_EQ(mkfifo(path().c_str(), 0600), 0); }
  ~Fifo() { pullOut(); }
  Fifo(const Fifo&) = delete;
  Fifo& operator=(const Fifo&) = delete;

  std::string path() const { return folder_.file("event0"); }
  /// Opens it with O_RDWR, since the reader may not be there yet.
  void plugIn() {
    pullOut();
    writer_ = open(path().c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    EXPECT_GE(writer_, 0);
  }
  void pullOut() {
    if (writer_ >= 0) close(writer_);
    writer_ = -1;
  }

  void write(const std::vector<input_event>& events) const {
    write(events, 0, events.size() * sizeof(input_event));
  }
  /// Writes the bytes of `events` from `first` up to, and without, `last`.
  void write(const std::vector<input_event>& events, std::size_t first, std::size_t last) const {
    const auto* const bytes = reinterpret_cast<const char*>(events.data());
    const auto count = static_cast<ssize_t>(last - first);
    EXPECT_EQ(::write(writer_, bytes + first, last - first), count);
  }

 private:
  suture::TemporaryDirectory folder_;
  int writer_ = -1;
};

}  // namespace robots::test
