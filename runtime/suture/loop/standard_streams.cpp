#include <fcntl.h>
#include <suture/loop/standard_streams.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <tuple>

namespace suture::loop {

void openStandardDescriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) >= 0) continue;
    std::ignore = open("/dev/null", O_RDONLY);  // takes the lowest number that is free
  }
}

SetupError outputLost() {
  return {"write to standard output", std::strerror(errno), "Make room, or write elsewhere"};
}

bool writeOut(const std::string& text) {
  const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (whole && std::fflush(stdout) == 0) return true;
  if (errno == EPIPE) return false;
  throw outputLost();
}

}  // namespace suture::loop
