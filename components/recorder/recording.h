#pragma once
// A recording holds one arm's poses during a run, the moments when a teleoperation began to follow,
// and those when a clutch or an emergency stop was pressed or released.

#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <utility>
#include <variant>
#include <vector>

#include "coordinator/emergency_stop.h"
#include "recorder/recording_lines.h"
#include "teleop/teleoperation.h"

namespace robots {

/// An ArmRow is one cycle of an arm, in its base frame, in m.
struct ArmRow {
  suture::Time stamp;  ///< when the arm measured the pose, in the cycle
  Eigen::Isometry3d measured = Eigen::Isometry3d::Identity();
  suture::Time goal_stamp;  ///< when the data were made from which the set-point was
  Eigen::Isometry3d setpoint = Eigen::Isometry3d::Identity();
  bool enabled = true;  ///< it obeys motion commands
};

/// Says that the clutch of a teleoperation was pressed, or that it was released or counts no more.
struct ClutchNews {
  bool pressed = false;
  suture::Time stamp;  ///< when the recorder heard of it
};

using Record = std::variant<ArmRow, FollowAnchors, ClutchNews, StopNews>;

struct Recording {
  std::vector<ArmRow> arm;              ///< their stamps ascend
  std::vector<FollowAnchors> followed;  ///< in the order of events
  std::vector<ClutchNews> clutch;       ///< likewise
  std::vector<StopNews> stops;          ///< likewise
  std::uint64_t lost = 0;               ///< records that are not in the file, by what was read
};

/// Writes one record as one line of JSON. Stamps are ns of the steady clock, quaternions w, x, y,
/// z.
void write(std::ostream& out, const Record& record);

/// One thread. Reads what write() wrote, even while it is being written.
class RecordingReader {
 public:
  explicit RecordingReader(std::filesystem::path file) : lines_(std::move(file)) {}

  /// Returns the whole records that are new since the last call; none before the file exists.
  /// Throws suture::SetupError that names the file and the line.
  Recording next();
  /// Returns the rest, once the file is not written any more. Also throws if the file was never
  /// there, or ends within a record.
  Recording rest();

 private:
  RecordingLines lines_;
};

/// Returns a whole recording, which must not be written any more.
Recording readRecording(const std::filesystem::path& file);

}  // namespace robots
