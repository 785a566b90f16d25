#pragma once
// These run and time other programs.

#include <filesystem>
#include <string>
#include <vector>

#include "bench/figures/statistics.h"

namespace bench {

struct CommandCost {
  double seconds = 0;  ///< processor time, user and system, that the program and its children took
  double megabytes = 0;  ///< the most memory that it or a child had at a time
};

using Command = std::vector<std::string>;

/// Runs the program `command[0]`, found on PATH, in `directory`, on this thread's processors.
/// Throws SetupError with the end of what it printed if it cannot be started or fails.
CommandCost run(const Command& command, const std::filesystem::path& directory);

/// Returns the words of a command line of compile_commands.json.
Command wordsOf(const std::string& commandLine);

/// Several ways to do a job, compared: in each round each of them once, so that what disturbs the
/// machine disturbs all alike.
class Comparison {
 public:
  /// Empties `directory` before each run. Returns the number of the contestant.
  std::size_t add(std::vector<Command> commands, std::filesystem::path directory);
  void run(std::size_t rounds, const std::string& what);
  Statistics seconds(std::size_t contestant) const;
  /// Returns what `contestant` takes beyond what `other` takes in the same round: a host that slows
  /// down for some rounds slows both.
  Statistics secondsBeyond(std::size_t other, std::size_t contestant) const;
  double megabytes(std::size_t contestant) const;

 private:
  struct Contestant {
    std::vector<Command> commands;
    std::filesystem::path directory;
    std::vector<double> seconds;
    double megabytes = 0;
  };

  std::vector<Contestant> contestants_;
};

}  // namespace bench
