#pragma once
// This ends a preparation that takes too long.

#include <suture/base/time.h>

namespace robots {

/// One thread.
class PreparationLimit {
 public:
  /// A preparation may take `longest`; with 0 it may take for ever.
  explicit PreparationLimit(suture::Duration longest) : longest_(longest) {}

  /// Says that a preparation begins, or begins anew.
  void begin() { since_ = suture::now(); }
  bool isOver() const {
    return longest_ > suture::Duration{0} && suture::now() - since_ >= longest_;
  }

 private:
  const suture::Duration longest_;
  suture::Time since_;
};

}  // namespace robots
