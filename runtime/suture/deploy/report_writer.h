#pragma once
// This sends a process's messages to the one who started it: one JSON object a line, or text.

#include <suture/base/time.h>
#include <suture/observe/report.h>

#include <cstdint>
#include <string>
#include <utility>

namespace suture {

/// Writes {"kind": "started"}, {"kind": "report", ...}, {"kind": "failure", "text": ..., "loss":
/// ...}, or the same for people, to a file descriptor, which it does not own; -1: writes nothing. A
/// reader that has gone away is not an error. It never waits for a slow reader: what that has not
/// taken waits here, and reports are left out meanwhile; failures are left out beyond 1 MiB, and
/// counted.
class ReportWriter {
 public:
  enum class Form { Json, Text };

  ReportWriter(int descriptor, Form form) : descriptor_(descriptor), form_(form) {}

  /// Says that all connections are made.
  void started();
  void report(const Report& report);
  /// `loss` says that another process is lost, or that the failure is due to that.
  void failure(const std::string& text, bool loss = false);
  /// Goes on with what waits here, for at most `patience`. Call it from time to time.
  void flush(Duration patience = Duration{0});
  /// Returns, once, why reports are written no more; "" if they are, or if their reader has gone.
  std::string takeProblem() { return std::exchange(problem_, ""); }

 private:
  void tell(const nlohmann::json& message, const std::string& text);

  int descriptor_;
  const Form form_;
  std::string waiting_;  // messages from where the reader has stopped
  std::string problem_;
  std::uint64_t leftOut_ = 0;  // failures, since the reader last heard of it
};

}  // namespace suture
