#pragma once
// These are poses: of and in the frames that their interface declares, unless they name others.

#include <suture/annotate.h>
#include <suture/base/frames.h>
#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

namespace robots {

/// A PoseStamped is a pose at a time: what CRTK's measured_cp, setpoint_cp and servo_cp carry.
struct SUTURE_TYPE() PoseStamped {
  /// The pose is that of the interface's moving frame in its reference frame.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  /// The pose was true at this time; for a set-point it is the stamp of the data from which it was
  /// made.
  suture::Time stamp;
  /// If it is false, do not use it.
  bool valid = false;
};

/// Says where one frame is in another, for a reader that cannot know from the interface which they
/// are.
struct SUTURE_TYPE() TransformStamped {
  /// The moving frame is here in the reference frame.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  /// Each is suture::frameId() of a frame's name; 0 means not named.
  suture::FrameId reference_frame = 0;
  suture::FrameId moving_frame = 0;
  suture::Time stamp;
  /// If it is false, do not use it.
  bool valid = false;
};

/// A PoseSample is the pose of the latency measurements: 120 bytes and no strings.
struct SUTURE_TYPE() PoseSample {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  SUTURE_FIELD(unit("m")) Eigen::Vector3d position = Eigen::Vector3d::Zero();
  suture::Time stamp;
  std::uint64_t sequence = 0;
  std::uint64_t flags = 0;
};
static_assert(sizeof(PoseSample) == 120);

/// A PosePrm has the fields of the cisst libraries' prmPositionCartesianGet, the type of the
/// paper's measurements.
struct SUTURE_TYPE() PosePrm {
  suture::Time timestamp;
  /// This is true if the provider stamps the data itself.
  bool automatic_timestamp = true;
  bool valid = false;
  SUTURE_FIELD(capacity(15)) std::string moving_frame;
  SUTURE_FIELD(capacity(15)) std::string reference_frame;
  /// The moving frame is here in the reference frame.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d position = Eigen::Isometry3d::Identity();
};

}  // namespace robots
