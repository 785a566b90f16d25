#pragma once
// These are the lengths (m) that the tables of the da Vinci Classic arms and their closed forms
// share, from the files that davinci.h names.

#include <numbers>

namespace robots::kinematics {

constexpr double kHalfPi = std::numbers::pi / 2;

constexpr double kPsmCarriage = 0.4318;  ///< from the remote centre back to the carriage
constexpr double kPsmShaft = 0.4162;     ///< from the carriage to the axis of the wrist pitch
constexpr double kPsmWrist = 0.0091;     ///< from the axis of the wrist pitch to the wrist yaw's

constexpr double kMtmUpperArm = 0.2794;     ///< from the shoulder to the elbow
constexpr double kMtmForearm = 0.3645;      ///< from the elbow to the platform's axis
constexpr double kMtmForearmDrop = 0.1506;  ///< along the platform's axis to the wrist's centre

}  // namespace robots::kinematics
