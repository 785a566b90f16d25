#pragma once
#include <suture/annotate.h>

#include <Eigen/Core>
#include <string>
#include <vector>
namespace demo {
struct SUTURE_TYPE() Sample {
  SUTURE_FIELD(bulk(), capacity(8)) std::vector<double> fine;
  SUTURE_FIELD(bulk()) Eigen::Matrix<double, 6, 7> large;
  SUTURE_FIELD(bulk()) Eigen::Matrix3d small;
  SUTURE_FIELD(bulk(), capacity(8)) std::string text;
  SUTURE_FIELD(bulk(), capacity(8)) std::vector<bool> flags;
  SUTURE_FIELD(bulk(), capacity(2, 8)) std::vector<std::vector<double>> rows;
};
}  // namespace demo
