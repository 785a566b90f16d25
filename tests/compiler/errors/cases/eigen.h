#pragma once
#include <suture/annotate.h>
#include <Eigen/Geometry>
#include <complex>
namespace demo {
struct SUTURE_TYPE() Matrices {
  Eigen::Matrix<double, Eigen::Dynamic, 3> dynamic;
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows;
  Eigen::Matrix<double, 300, 300> large;
  Eigen::Vector3cd complex;
  Eigen::Quaternionf rotation;
  Eigen::AffineCompact3d map;
};
}  // namespace demo
