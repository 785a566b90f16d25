#pragma once
// These numbers travel as one block of bytes.

#include <suture/annotate.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace shapes {

/// One of each that may be bulk().
struct SUTURE_TYPE() Bulk {
  SUTURE_FIELD(bulk(), capacity(6), unit("m")) std::vector<double> samples;
  SUTURE_FIELD(bulk(), range(-5, 5)) std::array<std::int16_t, 3> triple{};
  SUTURE_FIELD(bulk(), capacity(4)) std::vector<std::uint8_t> bytes;
  SUTURE_FIELD(bulk(), capacity(5)) Eigen::VectorXf line;
  SUTURE_FIELD(bulk()) Eigen::Matrix<double, 6, 7> jacobian = Eigen::Matrix<double, 6, 7>::Zero();
  SUTURE_FIELD(bulk(), capacity(3, 4)) Eigen::MatrixXd image;
};

}  // namespace shapes
