#pragma once
// A sink that writes one JSON object a line.

#include <suture/record/sink.h>

#include <filesystem>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

namespace suture {

/// Any number of collectors at a time; they wait for each other here, and for the file.
///   {"from":"Collector","row":17,"stamp":81234567,"measured_cp":{...},"measured_js":null}
///   {"from":"Collector","event":"mode","stamp":81234999,"value":"Enabled"}
///   {"from":"Collector","missed":3}
///   {"from":"PSM","fault":"the drive did not answer","first":2,"last":4}
/// A value is what `suture read --json` gives of it. A read whose name is that of another key of
/// these lines, as "row", is called "read.row". Stamps are ns of this machine's steady clock.
class JsonLines final : public Sink {
 public:
  /// Replaces the file. Throws SetupError if it cannot be written.
  explicit JsonLines(const std::filesystem::path& file);

  void row(const CollectedInterface& from, std::uint64_t number, Time stamp,
           std::span<const CollectedValue> values) override;
  void event(const CollectedInterface& from, std::uint16_t event, Time stamp,
             const std::byte* slot) override;
  void missed(const CollectedInterface& from, std::uint64_t count) override;
  /// `component` has had its faults number `first` to `last`, the last because of `reason`.
  void faults(const std::string& component, std::uint64_t first, std::uint64_t last,
              const std::string& reason);

  /// What has been written so far is in the file. Throws SetupError if the file system did not take
  /// all of it.
  void settle() override;
  /// The same. False if the file system did not take all of it.
  bool flush();

 private:
  void write(const nlohmann::ordered_json& line);

  const std::filesystem::path file_;
  std::mutex mutex_;  // of collectors' threads alone
  std::ofstream out_;
};

}  // namespace suture
