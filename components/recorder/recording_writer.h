#pragma once
// This writes rows of a control loop to a file.

#include <suture/base/line_file.h>
#include <suture/component/task/periodic_task.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

#include "recorder/recording_lines.h"

namespace robots {

/// A task pushes rows into a ring, and a task of this object writes them to the file, twenty times
/// a second. The destructor writes what is left. Call open() when the owner is configured, and
/// begin() when it starts: until begin() the file keeps an earlier recording, which so survives a
/// start that is refused. Rows that do not get into the file are counted in it as soon as it takes
/// something again, and the first loss is told on standard error. A row must have a function
/// write(std::ostream&, row) in its own namespace, and must be copied without an allocation.
template <class Row>
class RecordingWriter final : private suture::PeriodicTask {
 public:
  /// Changes nothing. The ring has room for `rows`. Throws suture::SetupError if the file cannot be
  /// written.
  RecordingWriter(const std::filesystem::path& file, std::size_t rows)
      : PeriodicTask({.period = std::chrono::milliseconds(50)}), file_(file), ring_(rows) {}
  ~RecordingWriter() override {
    stop();
    drain();
  }
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// The manager's thread, once: takes the file, and starts the thread that writes. Throws
  /// suture::SetupError if another recording has it.
  void open() {
    file_.take();
    start();
  }
  /// Any thread, after open(): from now on replaces what the file had.
  void begin() { begun_.store(true, std::memory_order_release); }

  /// One task's thread. Never blocks or allocates. Returns false if the row was dropped because the
  /// file is so far behind that the ring is full.
  bool push(const Row& row) {
    const std::size_t pushed = pushed_.load(std::memory_order_relaxed);
    if (pushed - written_.load(std::memory_order_acquire) == ring_.size()) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    ring_[pushed % ring_.size()] = row;
    pushed_.store(pushed + 1, std::memory_order_release);
    return true;
  }

  /// Any thread. Returns how many rows are not in the file, because it was too far behind, or
  /// because the file system did not take all of those that came within a twentieth of a second.
  std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

 private:
  void run() override { drain(); }
  void drain() {
    if (!begun_.load(std::memory_order_acquire)) return;
    const std::size_t before = written_.load(std::memory_order_relaxed);
    std::size_t written = before;
    std::ostringstream lines;
    while (written != pushed_.load(std::memory_order_acquire)) {
      write(lines, ring_[written % ring_.size()]);
      written_.store(++written, std::memory_order_release);
    }
    const std::uint64_t lost = this->lost();
    if (lost != told_) writeLost(lines, lost);
    if (file_.append(lines.str())) {
      told_ = lost;
    } else {
      lost_.fetch_add(written - before, std::memory_order_relaxed);
      complain();
    }
  }

  // The file takes nothing, so standard error has to tell.
  void complain() {
    if (std::exchange(complained_, true)) return;
    std::fprintf(stderr, "%s\n", file_.refusal().what());
  }

  suture::LineFile file_;
  // The entries are reused in turn; the counts never wrap. Only the pushing thread writes pushed_,
  // only the writing one written_.
  std::vector<Row> ring_;
  std::atomic<std::size_t> pushed_{0};
  std::atomic<std::size_t> written_{0};
  std::atomic<bool> begun_{false};
  std::atomic<std::uint64_t> lost_{0};
  std::uint64_t told_ = 0;  // by the file
  bool complained_ = false;
};

}  // namespace robots
