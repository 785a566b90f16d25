// The file system of a provider's black box fills up, and has room again, while a client commands
// the provider.

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "fault/system.h"

namespace suture {
namespace {

constexpr int kRounds = 3;
constexpr int kMost = 64;  // files: the disk has as many pages

/// Mounts it for this process and its program alone.
void mountSmallDisk(const std::string& folder) {
  const bool done = unshare(CLONE_NEWNS) == 0 &&
                    mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                    mount("none", folder.c_str(), "tmpfs", 0, "size=256k") == 0;
  if (!done) _exit(125);
}

/// It returns what stands in `told` between `begin` and `end`, which is empty for the rest of it.
std::optional<std::string> between(const std::string& told, const std::string& begin,
                                   const std::string& end) {
  const auto at = told.find(begin);
  if (at == std::string::npos) return std::nullopt;
  const auto from = at + begin.size();
  return told.substr(from, end.empty() ? end.npos : told.find(end, from) - from);
}

/// The file that the box says that it has written; empty: it says that it has not, and has left
/// nothing of it below `root`.
std::string fileIn(const std::string& told, const std::string& root) {
  if (const auto whole = between(told, "Its last state is in ", "")) return *whole;
  const auto file = between(told, "Its last state is not kept: recording to ", ": ");
  if (!file) {
    ADD_FAILURE() << told;
    return "";
  }
  EXPECT_TRUE(told.find("the file system did not take all of it") != std::string::npos ||
              told.find("the file cannot be written") != std::string::npos)
      << told;
  EXPECT_FALSE(std::filesystem::exists(root + *file))
      << "half a file takes the room that the next one needs";
  return "";
}

/// Its first line names the fault; rows follow. The task goes on and may replace the oldest of them
/// before they are read.
void expectWhole(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  ASSERT_TRUE(std::getline(in, line)) << file;
  EXPECT_EQ(nlohmann::json::parse(line).at("fault"), "a loose contact");
  int rows = 0, last = 0;
  for (; std::getline(in, line); ++rows) {
    const auto row = nlohmann::json::parse(line, nullptr, false);
    ASSERT_TRUE(row.is_object()) << line;
    ASSERT_GT(row.at("row"), last) << line;
    last = row.at("row");
  }
  EXPECT_GT(rows, 0) << file;
}

TEST(FullDisk, IsToldAndHurtsNoOther) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may mount a file system";
  System system;
  const std::string folder = system.file("box");
  std::filesystem::create_directory(folder);
  const auto manager = system.manager();
  const auto provider = system.provider("robot", [&] { mountSmallDisk(folder); }, {folder});
  // It fails from the start.
  std::string said = provider->line();
  while (said.find("component 'Shaky' faulted") == 0) said = provider->line();
  ASSERT_EQ(said, "ready");
  const auto client = system.client("busy", 5000);
  ASSERT_EQ(client->line(), "begun");
  ASSERT_EQ(client->line(), "ready");
  ASSERT_TRUE(system.works(true));

  const std::string root = "/proc/" + std::to_string(provider->pid()) + "/root";
  std::mt19937 random(faultSeed());
  int lost = 0;
  std::size_t kept = 0;
  for (int round = 0; round < kRounds; ++round) {
    std::string file = fileIn(provider->line(), root);
    for (int late = 0; file.empty(); ++late) {  // the disk had no room yet
      ASSERT_TRUE(late < 10 * kMost && !HasFailure()) << "there is room, and nothing is kept";
      file = fileIn(provider->line(), root);
    }
    std::vector<std::string> files;
    for (; !file.empty(); file = fileIn(provider->line(), root)) {
      files.push_back(root + file);
      ASSERT_LE(files.size(), std::size_t{kMost})
          << "more is said to be kept than there is room for";
    }
    ASSERT_FALSE(HasFailure());
    ++lost;
    // A shorter one may find room where a longer one did not.
    for (int more = std::uniform_int_distribution<int>(1, 8)(random); more > 0;) {
      file = fileIn(provider->line(), root);
      if (file.empty()) {
        --more;
        ++lost;
      } else {
        files.push_back(root + file);
        ASSERT_LE(files.size(), std::size_t{kMost}) << "on a disk that is full";
      }
    }
    ASSERT_FALSE(HasFailure());
    EXPECT_TRUE(system.works(true)) << "while the disk is full";
    for (const std::string& whole : files) {
      expectWhole(whole);
      std::filesystem::remove(whole);
    }
    kept += files.size();
  }
  for (const HistoryEntry& entry : system.clientsHistory()) {
    const bool event = entry.kind == HistoryEntry::Kind::Heard;
    ASSERT_TRUE(event || entry.epoch == 1) << "it reconnected";
  }
  for (Child* child : {client.get(), provider.get(), manager.get()}) {
    EXPECT_EQ(child->end(SIGTERM), 0);
  }
  expectSoundHistory(system.history());
  std::printf("seed %u: %d files that there was no room for, %zu whole, %zu entries\n", faultSeed(),
              lost, kept, system.history().size());
  EXPECT_GT(lost, 0);
}

}  // namespace
}  // namespace suture
