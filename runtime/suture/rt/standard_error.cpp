#include <poll.h>
#include <suture/rt/standard_error.h>
#include <unistd.h>

#include <climits>
#include <string>

namespace suture::rt {

// A pipe or terminal that poll() calls writable takes PIPE_BUF bytes without waiting.
bool printUnlessFull(std::string_view line) {
  pollfd room{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
  if (poll(&room, 1, 0) != 1 || room.revents != POLLOUT) return false;
  const std::string text = std::string(line.substr(0, PIPE_BUF - 1)) + '\n';
  return write(STDERR_FILENO, text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

}  // namespace suture::rt
