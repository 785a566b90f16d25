#pragma once
// A process's messages to whoever started it: one JSON object a line, or text.

#include <suture/observe/report.h>

#include <string>

namespace suture {

/// {"kind": "started"}, {"kind": "report", ...}, {"kind": "failure", "text": ...}; or the same for
/// people. Writes to a file descriptor, which it does not own; -1: says nothing. A reader that has
/// gone away is not an error.
class ReportWriter {
 public:
  enum class Form { Json, Text };

  ReportWriter(int descriptor, Form form) : descriptor_(descriptor), form_(form) {}

  /// All connections are made.
  void started() const;
  void report(const Report& report) const;
  void failure(const std::string& text) const;

 private:
  void tell(const nlohmann::json& message, const std::string& text) const;
  void write(const std::string& text) const;

  int descriptor_;
  Form form_;
};

}  // namespace suture
