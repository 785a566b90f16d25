#pragma once
// This is the contract of a simulated strand. It shows the truth, for cameras that draw it and for
// judges.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Core>

namespace robots {

struct SUTURE_TYPE() StrandState {
  /// Go from the left tip over the knot, which is the middle column, to the right tip, in the
  /// scene's frame.
  SUTURE_FIELD(unit("m")) Eigen::Matrix<double, 3, 61> nodes = Eigen::Matrix<double, 3, 61>::Zero();
  /// The strand has this length between the left tip and the knot.
  SUTURE_FIELD(unit("m")) double left_length = 0;
  /// The tensions pull at the links beside the knot, from either side.
  SUTURE_FIELD(unit("N")) double left_tension = 0;
  SUTURE_FIELD(unit("N")) double right_tension = 0;
  suture::Time stamp;
  /// This is false before both tips are known, and apart from each other.
  bool valid = false;
};

class SUTURE_INTERFACE() StrandView {
 public:
  virtual ~StrandView() = default;

  /// Returns the strand as it is at the end of the simulation's last cycle, which is its stamp.
  SUTURE_COMMAND() virtual const StrandState& strand() const = 0;
};

}  // namespace robots
