#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "fault/history/history.h"

namespace suture {

namespace {

const std::string kNone = "-";  // it stands for no word at all

using SumWords = std::array<std::uint64_t, sizeof(HistorySums) / sizeof(std::uint64_t)>;

std::string textOf(const HistorySums& sums) {
  std::string text;
  for (const std::uint64_t word : std::bit_cast<SumWords>(sums)) text += std::to_string(word) + " ";
  return text;
}

HistorySums readSums(std::istringstream& words) {
  SumWords sums{};
  for (std::uint64_t& word : sums) words >> word;
  return std::bit_cast<HistorySums>(sums);
}

std::int64_t wallClock() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

}  // namespace

HistoryLog::HistoryLog(const std::string& file)
    : file_(open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600)) {
  if (file_ < 0) throw std::runtime_error("cannot write " + file);
}

HistoryLog::~HistoryLog() { close(file_); }

void HistoryLog::write(const HistoryEntry& entry) {
  const std::string line =
      std::to_string(static_cast<int>(entry.kind)) + " " + std::to_string(toNanoseconds(entry.at)) +
      " " + std::to_string(entry.client) + " " + std::to_string(entry.id) + " " +
      std::to_string(entry.epoch) + " " + std::to_string(entry.limit.count()) + " " +
      std::to_string(static_cast<int>(entry.error)) + " " + std::to_string(wallClock()) + " " +
      std::to_string(entry.age.count()) + " " + (entry.lane.empty() ? kNone : entry.lane) + " " +
      textOf(entry.sums) + ".\n";
  if (::write(file_, line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
    throw std::runtime_error("cannot write a history");
  }
}

std::vector<HistoryEntry> readHistory(const std::vector<std::string>& files) {
  std::vector<HistoryEntry> all;
  for (const std::string& file : files) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      HistoryEntry entry;
      int kind = 0, error = 0;
      std::int64_t at = 0, limit = 0, age = 0;
      std::string last;
      words >> kind >> at >> entry.client >> entry.id >> entry.epoch >> limit >> error >>
          entry.wall >> age >> entry.lane;
      entry.sums = readSums(words);
      words >> last;
      if (last != ".") continue;
      entry.kind = static_cast<HistoryEntry::Kind>(kind);
      entry.at = fromNanoseconds(at);
      entry.limit = Duration(limit);
      entry.error = static_cast<Errc>(error);
      entry.age = Duration(age);
      if (entry.lane == kNone) entry.lane.clear();
      all.push_back(entry);
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const HistoryEntry& a, const HistoryEntry& b) { return a.at < b.at; });
  return all;
}

}  // namespace suture
