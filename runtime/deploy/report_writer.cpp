#include <suture/deploy/report_writer.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

namespace suture {

void ReportWriter::started() const { write({{"kind", "started"}}); }

void ReportWriter::report(const Report& report) const {
  nlohmann::json message = toJson(report);
  message["kind"] = "report";
  write(message);
}

void ReportWriter::failure(const std::string& text) const {
  write({{"kind", "failure"}, {"text", text}});
}

void ReportWriter::write(const nlohmann::json& message) const {
  if (descriptor_ < 0) return;
  // A fault's text is a program's own; what is not UTF-8 in it must not end the process.
  const std::string line =
      message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  std::string_view left = line;
  while (!left.empty()) {
    const ssize_t written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno != EINTR) return;
    if (written > 0) left.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace suture
