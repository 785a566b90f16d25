#pragma once
// This is a file that one recording at a time fills with lines.

#include <suture/base/errors.h>

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace suture {

/// One thread at a time may use it. A start that is refused must not cost an earlier recording, so
/// the file stays as it was until the first append(), which replaces it.
class LineFile {
 public:
  /// Changes nothing. Throws SetupError if the file cannot be written.
  explicit LineFile(std::filesystem::path file);
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  const std::filesystem::path& path() const { return file_; }
  /// Before append(): opens the file, which no other LineFile may have then. Does nothing when it
  /// is called again. Throws SetupError, also for a pipe that nobody reads.
  void take();
  /// Returns false if the file system did not take all of it; then the file has none of it, and
  /// ends with a whole line. Also returns false once the file has been removed, since nobody could
  /// read it then; a file that has been renamed is written under its new name. Waits for a reader
  /// of a pipe who is slow, but gives the pipe up for good if he takes nothing for 1 s.
  bool append(std::string_view lines);
  /// Returns why append() has returned false.
  SetupError refusal() const;

 private:
  enum class Problem : std::uint8_t { NotTaken, Removed, NotRead };

  bool writeAll(std::string_view lines);
  void giveUp();

  const std::filesystem::path file_;
  int descriptor_ = -1;
  bool regular_ = false;                 // no device or pipe, which others may use too
  bool replaced_ = false;                // what it had before is gone
  Problem problem_ = Problem::NotTaken;  // the last that there was
  int error_ = 0;                        // why it was not taken, as errno
};

}  // namespace suture
