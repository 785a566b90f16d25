#pragma once
// These are kinematics as questions, with the reason if there is no answer: the cisst libraries'
// prmForwardKinematicsRequest and its relatives.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace robots {

struct SUTURE_TYPE() ForwardKinematicsRequest {
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> jp;
};

struct SUTURE_TYPE() ForwardKinematicsResponse {
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d cp = Eigen::Isometry3d::Identity();
  bool result = false;
  /// Says why there is no answer; empty when `result`.
  SUTURE_FIELD(capacity(63)) std::string message;
};

struct SUTURE_TYPE() InverseKinematicsRequest {
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d cp = Eigen::Isometry3d::Identity();
  /// The search begins here.
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> jp;
};

struct SUTURE_TYPE() InverseKinematicsResponse {
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> jp;
  bool result = false;
  /// Says why there is no answer; empty when `result`.
  SUTURE_FIELD(capacity(63)) std::string message;
};

}  // namespace robots
