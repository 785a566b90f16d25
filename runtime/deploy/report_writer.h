#pragma once
// A process's messages to whoever started it: one JSON object a line.

#include <suture/observe/report.h>

#include <string>

namespace suture {

/// {"kind": "started"}, {"kind": "report", ...}, {"kind": "failure", "text": ...}. Writes to a file
/// descriptor, which it does not own; -1: says nothing. A reader that has gone away is not an
/// error.
class ReportWriter {
 public:
  explicit ReportWriter(int descriptor) : descriptor_(descriptor) {}

  /// All connections are made.
  void started() const;
  void report(const Report& report) const;
  void failure(const std::string& text) const;

 private:
  void write(const nlohmann::json& message) const;

  int descriptor_;
};

}  // namespace suture
