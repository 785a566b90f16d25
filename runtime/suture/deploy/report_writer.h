#pragma once
// A process's messages to whoever started it: one JSON object a line, or text.

#include <suture/base/time.h>
#include <suture/observe/report.h>

#include <string>

namespace suture {

/// {"kind": "started"}, {"kind": "report", ...}, {"kind": "failure", "text": ..., "loss": ...}; or
/// the same for people. Writes to a file descriptor, which it does not own; -1: says nothing. A
/// reader that has gone away is not an error. One that is slow is never waited for: what it has not
/// taken waits here, and reports are left out meanwhile.
class ReportWriter {
 public:
  enum class Form { Json, Text };

  ReportWriter(int descriptor, Form form) : descriptor_(descriptor), form_(form) {}

  /// All connections are made.
  void started();
  void report(const Report& report);
  /// `loss`: of another process, or due to that.
  void failure(const std::string& text, bool loss = false);
  /// Goes on with what waits here, for at most `patience`. To be called now and then.
  void flush(Duration patience = Duration{0});

 private:
  void tell(const nlohmann::json& message, const std::string& text);

  int descriptor_;
  const Form form_;
  std::string waiting_;  // of what has been told; begins where the reader has stopped
};

}  // namespace suture
