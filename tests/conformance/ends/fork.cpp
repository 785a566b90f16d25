#include "conformance/ends/fork.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace conformance {
namespace {

constexpr std::size_t kMostBytes = 100'000;

void say(int socket, const std::string& bytes) {
  if (send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) std::perror("say");
}

/// Receives one message; returns false if the other end has gone.
bool hear(int socket, std::string& bytes) {
  bytes.resize(kMostBytes);
  const ssize_t size = recv(socket, bytes.data(), bytes.size(), 0);
  bytes.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
  return size > 0;
}

// The copy is noexcept, so that what is thrown in it does not bring it back among the tests.
[[noreturn]] void serve(int socket, const std::function<std::shared_ptr<void>()>& make) noexcept {
  std::shared_ptr<void> made = make();
  for (std::string asked; hear(socket, asked);) {
    Fork::Deed deed;
    std::memcpy(&deed, asked.data(), sizeof deed);
    // An empty message cannot be told from the end.
    say(socket, "=" + deed(made.get(), asked.substr(sizeof deed)));
  }
  made = nullptr;
  std::fflush(stdout);
  _exit(testing::Test::HasFailure() ? 1 : 0);
}

}  // namespace

Fork::Fork(const std::function<std::shared_ptr<void>()>& make) {
  int sockets[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets) != 0) std::abort();
  std::fflush(stdout);
  pid_ = fork();
  if (pid_ < 0) std::abort();
  if (pid_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    close(sockets[0]);
    serve(sockets[1], make);
  }
  close(sockets[1]);
  socket_ = sockets[0];
}

Fork::~Fork() {
  close(socket_);
  int status = 0;
  waitpid(pid_, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "the other process: " << status;
}

std::string Fork::ask(Deed deed, const std::string& given) {
  const std::lock_guard lock(asking_);
  std::string message(sizeof deed, '\0');
  std::memcpy(message.data(), &deed, sizeof deed);
  say(socket_, message + given);
  std::string answer;
  EXPECT_TRUE(hear(socket_, answer)) << "the other process has ended";
  return answer.empty() ? "" : answer.substr(1);
}

}  // namespace conformance
