#include "run/space.h"

#include <fmt/format.h>
#include <suture/base/errors.h>

#include <system_error>

#include "timing/seconds.h"

namespace demo {
namespace {

constexpr double kBytesOfArmRow = 420, kBytesOfKnotRow = 5000;  // in JSON
constexpr double kGigabyte = 1e9;

/// Returns how many bytes a component records in a second; 0 if it is no recorder.
double recordedBy(const suture::ComponentEntry& component) {
  const bool isOfArm = component.className == "Recorder";
  if (!isOfArm && component.className != "KnotRecorder") return 0;
  const double usual = isOfArm ? 0.001 : 0.02;  // s, which the classes have by default
  return (isOfArm ? kBytesOfArmRow : kBytesOfKnotRow) / component.parameters.value("period", usual);
}

}  // namespace

void requireSpace(const Plan& plan, suture::Duration length, const std::filesystem::path& folder) {
  double needed = 0;  // bytes
  for (const suture::ProcessEntry& process : plan.deployment().processes()) {
    for (const suture::ComponentEntry& component : process.components) {
      needed += recordedBy(component) * robots::inSeconds(length);
    }
  }
  std::error_code unknown;
  const auto space = std::filesystem::space(folder, unknown);
  if (unknown || needed <= static_cast<double>(space.available)) return;
  throw suture::SetupError(
      "recording this run in " + folder.string(),
      fmt::format("it takes {:.1f} GB, and only {:.1f} GB are free there", needed / kGigabyte,
                  static_cast<double>(space.available) / kGigabyte),
      "Let TMPDIR name a folder on a larger disk, or run for fewer --seconds or at a lower --rate");
}

}  // namespace demo
