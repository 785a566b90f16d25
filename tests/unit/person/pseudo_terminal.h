#pragma once
// This is a pseudo terminal, whose keys a test presses.

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <string_view>

namespace robots::test {

class PseudoTerminal {
 public:
  PseudoTerminal() {
    EXPECT_EQ(openpty(&person_, &program_, nullptr, nullptr, nullptr), 0);
    path_ = ttyname(program_);
  }
  ~PseudoTerminal() {
    hangUp();
    close(program_);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  const std::string& path() const { return path_; }
  /// Types the keys, and returns when they can be read, since the kernel takes a while to hand them
  /// over. If the terminal waits for the end of a line, this returns at once.
  void type(std::string_view keys) const {
    EXPECT_EQ(write(person_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
    if (handsOverKeys()) awaitNews();
  }
  void hangUp() {
    if (person_ < 0) return;
    close(person_);
    person_ = -1;
    awaitNews();
  }
  /// Tells if the terminal hands keys over one by one, without showing them.
  bool handsOverKeys() const {
    termios mode{};
    EXPECT_EQ(tcgetattr(program_, &mode), 0);
    return (mode.c_lflag & (ICANON | ECHO)) == 0;
  }
  /// Sets the terminal as a shell that has taken it does.
  void waitForLines() const {
    termios mode{};
    EXPECT_EQ(tcgetattr(program_, &mode), 0);
    mode.c_lflag |= ICANON | ECHO;
    EXPECT_EQ(tcsetattr(program_, TCSANOW, &mode), 0);
  }

 private:
  void awaitNews() const {
    pollfd news{.fd = program_, .events = POLLIN, .revents = 0};
    EXPECT_EQ(poll(&news, 1, std::chrono::milliseconds(std::chrono::seconds(10)).count()), 1);
  }

  int person_ = -1, program_ = -1;
  std::string path_;
};

}  // namespace robots::test
