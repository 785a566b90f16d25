#include <fcntl.h>
#include <gtest/gtest.h>
#include <suture/net/refusals.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <thread>

#include "support/eventually.h"

namespace suture::net {
namespace {

/// This is standard error while it lives: a pipe that nobody reads until drain().
class UnreadStandardError {
 public:
  UnreadStandardError() : before_(dup(STDERR_FILENO)) {
    EXPECT_EQ(pipe2(pipe_.data(), O_CLOEXEC), 0);
    fcntl(pipe_[0], F_SETFL, O_NONBLOCK);
    dup2(pipe_[1], STDERR_FILENO);
  }
  ~UnreadStandardError() {
    dup2(before_, STDERR_FILENO);
    for (const int one : {before_, pipe_[0], pipe_[1]}) close(one);
  }
  UnreadStandardError(const UnreadStandardError&) = delete;
  UnreadStandardError& operator=(const UnreadStandardError&) = delete;

  void fill() const {
    fcntl(STDERR_FILENO, F_SETFL, O_NONBLOCK);
    std::array<char, 4096> bytes{};
    while (write(STDERR_FILENO, bytes.data(), bytes.size()) > 0) {
    }
    fcntl(STDERR_FILENO, F_SETFL, 0);
  }
  std::string drain() const {
    std::string all;
    std::array<char, 4096> bytes{};
    for (ssize_t count; (count = read(pipe_[0], bytes.data(), bytes.size())) > 0;) {
      all.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return all;
  }

 private:
  const int before_;
  std::array<int, 2> pipe_{};
};

// The control thread reports them, and whoever waits for it loses its connection.
TEST(Refusals, DoNotWaitUntilSomebodyReadsThem) {
  const UnreadStandardError error;
  error.fill();
  Refusals refusals("robot");
  std::atomic<bool> done = false;
  std::thread control([&] {
    refusals.add("user 7", "talk to process 'robot'");
    done = true;
  });
  EXPECT_TRUE(eventually([&] { return done.load(); }));
  error.drain();
  control.join();
  EXPECT_EQ(refusals.summary().count, 1u);
  error.drain();
  refusals.add("user 7", "talk to process 'robot'");
  EXPECT_EQ(error.drain(), "robot: refused user 7: talk to process 'robot'\n")
      << "it could not be printed before";
}

}  // namespace
}  // namespace suture::net
