#include "bench/table2/processes/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <suture/base/errors.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <utility>

namespace bench {
namespace {

using suture::SetupError;

constexpr const char* kSelf = "/proc/self/exe";

std::array<int, 2> makePipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw SetupError("a pipe to another process", std::strerror(errno), "Raise ulimit -n");
  }
  return ends;
}

pid_t spawn(const std::vector<std::string>& arguments, int input, int output) {
  std::vector<std::string> words{"suture-bench"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  pid_t pid = -1;
  const int error = posix_spawn(&pid, kSelf, &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw SetupError("starting this program as a server", std::strerror(error),
                     "Allow one more process");
  }
  return pid;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments) {
  const auto toChild = makePipe(), fromChild = makePipe();
  input_ = toChild[1];
  output_ = fromChild[0];
  pid_ = spawn(arguments, toChild[0], fromChild[1]);
  close(toChild[0]);
  close(fromChild[1]);
}

ChildProcess::~ChildProcess() {
  closeInput();
  close(output_);
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
}

void ChildProcess::closeInput() {
  if (input_ >= 0) close(std::exchange(input_, -1));
}

std::vector<std::byte> ChildProcess::finish() {
  closeInput();
  std::vector<std::byte> written;
  std::array<std::byte, 65536> chunk;
  for (;;) {
    const ssize_t count = read(output_, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    written.insert(written.end(), chunk.data(), chunk.data() + count);
  }
  int status = 0;
  waitpid(std::exchange(pid_, -1), &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw SetupError("the result of the server process",
                     WIFSIGNALED(status) ? strsignal(WTERMSIG(status))
                                         : "exit status " + std::to_string(WEXITSTATUS(status)),
                     "Its own message is above");
  }
  return written;
}

void awaitEndOfInput() {
  char ignored = 0;
  while (read(STDIN_FILENO, &ignored, 1) > 0) {
  }
}

}  // namespace bench
