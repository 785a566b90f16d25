#pragma once
// This is a sink that writes one JSON object to each line.

#include <suture/base/line_file.h>
#include <suture/record/sink.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

namespace suture {

/// Serves any number of collectors at the same time, which wait for each other here and for the
/// file. Writes lines like these:
///   {"from":"Collector","row":17,"stamp":81234567,"measured_cp":{...},"measured_js":null}
///   {"from":"Collector","event":"mode","stamp":81234999,"value":"Enabled"}
///   {"from":"Collector","missed":3}
///   {"from":"PSM","fault":"the drive did not answer","first":2,"last":4}
/// A value is written as `suture read --json` shows it. A read whose name is that of another key of
/// these lines, such as "row", is called "read.row". Stamps are ns of this machine's steady clock.
class JsonLines final : public Sink {
 public:
  /// Changes nothing. Throws SetupError if the file cannot be written.
  explicit JsonLines(const std::filesystem::path& file) : file_(file) {}

  /// Takes the file, and leaves what it holds until something is brought into it. Throws SetupError
  /// if another recording has it.
  void begin() override;

  void row(const CollectedInterface& from, std::uint64_t number, Time stamp,
           std::span<const CollectedValue> values) override;
  void event(const CollectedInterface& from, std::uint16_t event, Time stamp,
             const std::byte* slot) override;
  void missed(const CollectedInterface& from, std::uint64_t count) override;
  /// Writes that `component` has had its faults number `first` to `last`, of which the last has
  /// `reason`.
  void faults(const std::string& component, std::uint64_t first, std::uint64_t last,
              const std::string& reason);

  /// Brings what has been written so far into the file. Throws NotKept if the file system did not
  /// take something of this collector since it was called last: none of that is in the file then,
  /// which ends with a whole line.
  void settle(const CollectedInterface& from) override;
  /// Does the same for all collectors. Throws SetupError with the reason if something was not kept.
  void flush();

 private:
  struct Count {
    std::uint64_t collected = 0, missed = 0;
  };
  using Counts = std::map<std::string, Count>;  // by collector

  void write(const std::string& from, const nlohmann::ordered_json& line, Count count);
  void put();
  static void add(Counts& counts, const std::string& from, Count more);

  std::mutex mutex_;  // locked only by the threads of collectors
  LineFile file_;
  std::string waiting_;  // whole lines that are not in the file yet
  Counts told_;          // how much stands in those lines
  Counts lost_;          // what the file system did not take, until the collector knows
};

}  // namespace suture
