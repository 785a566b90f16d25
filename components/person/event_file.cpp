#include "person/event_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace robots {

bool EventFile::open() {
  close();
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  error_ = isOpen() ? 0 : errno;
  if (isOpen() && !isOfEvents()) {
    close();
    error_ = ENODEV;
  }
  return isOpen();
}

// Returns false for an ordinary file, because it would be read again from its beginning each time
// that it is opened.
bool EventFile::isOfEvents() const {
  struct stat status {};
  return fstat(descriptor_, &status) == 0 && (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode));
}

std::span<const input_event> EventFile::read() {
  if (!isOpen()) return {};
  auto* const bytes = reinterpret_cast<char*>(events_.data());
  std::memmove(bytes, bytes + taken_, filled_ - taken_);
  filled_ -= taken_;
  taken_ = 0;
  const ssize_t got = ::read(descriptor_, bytes + filled_, sizeof(events_) - filled_);
  if (got <= 0) {
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return {};
    error_ = got < 0 ? errno : 0;
    close();
    return {};
  }
  filled_ += static_cast<std::size_t>(got);
  const std::size_t whole = filled_ / sizeof(input_event);
  taken_ = whole * sizeof(input_event);
  return {events_.data(), whole};
}

void EventFile::close() {
  if (isOpen()) ::close(descriptor_);
  descriptor_ = -1;
  filled_ = taken_ = 0;
}

}  // namespace robots
