#include "person/terminal.h"

#include <fcntl.h>
#include <suture/base/errors.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>

namespace robots {

// Opens the terminal anew, because O_NONBLOCK holds for all who share an open file, and others may
// print to that of standard input.
Terminal::Terminal(const std::string& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)),
      before_(std::make_unique<termios>()),
      own_(std::make_unique<termios>()) {
  const bool usable = tcgetattr(descriptor_, before_.get()) == 0 && isInForeground();
  if (!usable) {
    close();
    throw suture::SetupError("reading keys from " + path,
                             "it is no terminal in whose foreground this process runs",
                             "Start the process by hand in a terminal, without \"&\"");
  }
  *own_ = *before_;
  own_->c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  own_->c_cc[VMIN] = 1;
  own_->c_cc[VTIME] = 0;
}

Terminal::~Terminal() {
  if (isOpen() && isInForeground()) apply(*before_);
  close();
}

// Returns true in the foreground, and for a terminal that does not control this process, which has
// no foreground.
bool Terminal::isInForeground() const {
  const pid_t group = tcgetpgrp(descriptor_);
  return group == -1 || group == getpgrp();
}

void Terminal::takeOver() {
  if (isOpen()) apply(*own_);
}

void Terminal::apply(const termios& mode) const {
  tcsetattr(descriptor_, TCSANOW, &mode);
  tcflush(descriptor_, TCIFLUSH);
}

std::span<const char> Terminal::read() {
  if (!isOpen()) return {};
  const ssize_t got = ::read(descriptor_, keys_.data(), keys_.size());
  if (got > 0) return {keys_.data(), static_cast<std::size_t>(got)};
  if (got == 0 || (errno != EAGAIN && errno != EINTR)) close();
  return {};
}

void Terminal::close() {
  if (isOpen()) ::close(descriptor_);
  descriptor_ = -1;
}

}  // namespace robots
