#pragma once
// Takes records from a control loop to a file.

#include <suture/component/periodic_task.h>

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <vector>

#include "recorder/recording.h"

namespace robots {

/// A ring that a task fills, and a task of its own that writes to the file, twenty times a second.
/// The destructor writes what is left.
class RecordingWriter final : private suture::PeriodicTask {
 public:
  /// Replaces the file. Throws suture::SetupError if it cannot be written.
  explicit RecordingWriter(const std::filesystem::path& file);
  ~RecordingWriter() override;
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// From one task's thread. Never blocks, never allocates; false if the record was dropped because
  /// the file is seconds behind.
  bool push(const Record& record);

 private:
  void run() override { drain(); }
  void drain();

  std::ofstream out_;
  // Reused in turn; the counts never wrap. Only the pushing thread writes pushed_, only the writing
  // one written_.
  std::vector<Record> ring_;
  std::atomic<std::size_t> pushed_{0};
  std::atomic<std::size_t> written_{0};
};

}  // namespace robots
