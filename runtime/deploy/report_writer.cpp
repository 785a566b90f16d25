#include <suture/deploy/report_writer.h>
#include <suture/observe/text.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

namespace suture {

void ReportWriter::started() const { tell({{"kind", "started"}}, "started\n"); }

void ReportWriter::report(const Report& report) const {
  if (descriptor_ < 0) return;
  nlohmann::json message = toJson(report);
  message["kind"] = "report";
  tell(message, toText(report));
}

void ReportWriter::failure(const std::string& text) const {
  tell({{"kind", "failure"}, {"text", text}}, "failure: " + text + "\n");
}

void ReportWriter::tell(const nlohmann::json& message, const std::string& text) const {
  if (form_ == Form::Text) return write(text);
  // A fault's text is a program's own; what is not UTF-8 in it must not end the process.
  write(message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void ReportWriter::write(const std::string& text) const {
  if (descriptor_ < 0) return;
  std::string_view left = text;
  while (!left.empty()) {
    const ssize_t written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno != EINTR) return;
    if (written > 0) left.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace suture
