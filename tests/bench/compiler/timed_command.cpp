#include "bench/compiler/timed_command.h"

#include <fcntl.h>
#include <spawn.h>
#include <suture/base/errors.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

#include "bench/progress.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
using suture::SetupError;

constexpr std::size_t kShown = 2000;

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

std::string endOf(const fs::path& file) {
  std::ifstream in(file);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  return text.substr(text.size() - std::min(text.size(), kShown));
}

pid_t spawn(const Command& command, const fs::path& directory, const fs::path& output) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t pid = -1;
  const int error = posix_spawnp(&pid, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw SetupError("running " + command[0], std::strerror(error),
                     "Install it with .ci/install compiler and build the preset release");
  }
  return pid;
}

}  // namespace

CommandCost run(const Command& command, const fs::path& directory) {
  const fs::path output = directory / ".output";
  const pid_t pid = spawn(command, directory, output);
  int status = 0;
  rusage usage{};
  while (wait4(pid, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw SetupError("running " + command[0], "it failed:\n" + endOf(output),
                     "Run it by hand in " + directory.string());
  }
  return {secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

Command wordsOf(const std::string& commandLine) {
  Command words(1);
  bool quoted = false;
  for (std::size_t i = 0; i < commandLine.size(); ++i) {
    const char c = commandLine[i];
    if (c == '"') {
      quoted = !quoted;
    } else if (c == '\\' && i + 1 < commandLine.size()) {
      words.back() += commandLine[++i];
    } else if (c == ' ' && !quoted) {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  std::erase(words, "");
  return words;
}

std::size_t Comparison::add(std::vector<Command> commands, fs::path directory) {
  contestants_.push_back({std::move(commands), std::move(directory), {}, 0});
  return contestants_.size() - 1;
}

void Comparison::run(std::size_t rounds, const std::string& what) {
  // The first round fills the caches and does not count, unless it is the only one.
  for (std::size_t round = rounds > 1 ? 0 : 1; round <= rounds; ++round) {
    progress(what + ", round " + std::to_string(round) + " of " + std::to_string(rounds));
    for (Contestant& one : contestants_) {
      fs::remove_all(one.directory);
      fs::create_directories(one.directory);
      double seconds = 0;
      for (const Command& command : one.commands) {
        const CommandCost cost = bench::run(command, one.directory);
        seconds += cost.seconds;
        one.megabytes = std::max(one.megabytes, cost.megabytes);
      }
      if (round > 0) one.seconds.push_back(seconds);
    }
  }
  progress("");
}

Statistics Comparison::seconds(std::size_t contestant) const {
  return statisticsOf(contestants_[contestant].seconds);
}

Statistics Comparison::secondsBeyond(std::size_t other, std::size_t contestant) const {
  std::vector<double> differences = contestants_[contestant].seconds;
  for (std::size_t round = 0; round < differences.size(); ++round) {
    differences[round] -= contestants_[other].seconds[round];
  }
  return statisticsOf(std::move(differences));
}

double Comparison::megabytes(std::size_t contestant) const {
  return contestants_[contestant].megabytes;
}

}  // namespace bench
