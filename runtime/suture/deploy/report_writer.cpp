#include <poll.h>
#include <suture/deploy/report_writer.h>
#include <suture/observe/text.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>

namespace suture {
namespace {

constexpr std::size_t kMostWaiting = std::size_t{1} << 20;

// A pipe that has room takes this much at once without blocking.
constexpr std::size_t kAtOnce = PIPE_BUF;

/// Returns what poll() does.
int awaitRoom(int descriptor, Duration patience) {
  const auto wait = std::chrono::ceil<std::chrono::milliseconds>(std::max(patience, Duration{0}));
  pollfd asked{.fd = descriptor, .events = POLLOUT, .revents = 0};
  return poll(&asked, 1, static_cast<int>(wait.count()));
}

}  // namespace

void ReportWriter::started() { tell({{"kind", "started"}}, "started\n"); }

void ReportWriter::report(const Report& report) {
  flush();
  if (descriptor_ < 0 || !waiting_.empty()) return;
  if (const std::uint64_t count = std::exchange(leftOut_, 0); count > 0) {
    const std::string text =
        std::to_string(count) + " failures are left out here, whose text nobody has read in time";
    failure(text);
  }
  nlohmann::json message = toJson(report);
  message["kind"] = "report";
  tell(message, toText(report));
}

void ReportWriter::failure(const std::string& text, bool loss) {
  tell({{"kind", "failure"}, {"text", text}, {"loss", loss}}, "failure: " + text + "\n");
}

void ReportWriter::tell(const nlohmann::json& message, const std::string& text) {
  if (descriptor_ < 0) return;
  if (waiting_.size() > kMostWaiting) {
    ++leftOut_;
    return;
  }
  if (form_ == Form::Text) {
    waiting_ += text;
  } else {
    // A fault's text is a program's own; what is not UTF-8 in it must not end the process.
    waiting_ += message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  }
  flush();
}

void ReportWriter::flush(Duration patience) {
  const Time deadline = fromNow(patience);
  while (!waiting_.empty()) {
    const int ready = awaitRoom(descriptor_, deadline - now());
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return;
    const ssize_t written =
        ::write(descriptor_, waiting_.data(), std::min(waiting_.size(), kAtOnce));
    if (written >= 0) {
      waiting_.erase(0, static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      return;
    } else if (errno != EINTR) {
      if (errno != EPIPE) {
        problem_ = std::string("write reports: ") + std::strerror(errno) +
                   ". None is written any more: make room, or give another file with --report-fd";
      }
      descriptor_ = -1;
      waiting_.clear();
    }
  }
}

}  // namespace suture
