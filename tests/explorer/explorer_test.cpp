#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "explorer/seeds.h"
#include "explorer/world.h"
#include "paths.h"

namespace explorer {
namespace {

std::uint64_t asked(const char* variable, std::uint64_t otherwise, std::uint64_t least) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : numberIn(variable, text, least);
}

Seeds seedsOfThisRun() { return {asked("SUTURE_FIRST_SEED", 1, 0), asked("SUTURE_SEEDS", 200, 1)}; }

/// Runs it, tells what is broken as a line for the file of failed seeds, and shows its trace if the
/// environment asks for that.
Outcome expectSound(std::uint64_t seed) {
  Outcome outcome = runWorld(seed);
  for (const std::string& what : outcome.broken) {
    ADD_FAILURE() << seed << "  " << what << " (" << outcome.setup << ")";
  }
  if (std::getenv("SUTURE_TRACE") != nullptr) std::printf("%s", toString(outcome.trace).c_str());
  return outcome;
}

std::vector<std::uint64_t> failedSeeds() {
  std::vector<std::uint64_t> seeds;
  std::ifstream file(paths::kFailedSeeds);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    if (std::uint64_t seed = 0; words >> seed) seeds.push_back(seed);
  }
  return seeds;
}

/// Keeps processors busy that others want, until the end.
class BusyProcesses {
 public:
  explicit BusyProcesses(int count) {
    for (int i = 0; i < count; ++i) {
      const pid_t one = fork();
      if (one == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (volatile unsigned turns = 0;;) turns = turns + 1;
      }
      processes_.push_back(one);
    }
  }
  ~BusyProcesses() {
    for (const pid_t one : processes_) {
      kill(one, SIGKILL);
      waitpid(one, nullptr, 0);
    }
  }
  BusyProcesses(const BusyProcesses&) = delete;
  BusyProcesses& operator=(const BusyProcesses&) = delete;

 private:
  std::vector<pid_t> processes_;
};

/// Each runs one block of the seeds.
class Explorer : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Explorer, FindsNothingUnderNewSeeds) {
  const auto [first, count] = seedsOf(GetParam(), seedsOfThisRun());
  unsigned answered = 0, harms = 0;
  std::map<std::string, std::uint64_t> lanes;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const Outcome outcome = expectSound(seed);
    answered += outcome.answered;
    harms += outcome.harms;
    ++lanes[outcome.lane];
  }
  EXPECT_EQ(answered, count);
  EXPECT_GE(harms, count);
  std::printf("%lu worlds met %u harms", count, harms);
  for (const auto& [lane, worlds] : lanes) std::printf(", %lu on %s", worlds, lane.c_str());
  std::printf(".\n");
}

INSTANTIATE_TEST_SUITE_P(Blocks, Explorer,
                         testing::Range(std::uint64_t{0}, blocksOf(seedsOfThisRun().count)));

TEST(Seeds, FailuresOfThePastAreGone) {
  for (const std::uint64_t seed : failedSeeds()) expectSound(seed);
}

TEST(Seeds, RepeatWhatTheyDid) {
  const BusyProcesses beside(3);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const std::string first = toString(runWorld(seed).trace);
    EXPECT_EQ(first, toString(runWorld(seed).trace)) << "seed " << seed;
    EXPECT_GT(first.size(), 1000u);
  }
}

}  // namespace
}  // namespace explorer
