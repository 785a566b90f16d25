#pragma once
// This is a component whose parameters somebody else has declared.

#include <suture/annotate.h>
#include <suture/component/device.h>

namespace guest {

/// It belongs to a library, and cannot be edited.
struct Limits {
  double low = -1, high = 1;
};

}  // namespace guest

namespace shapes {

SUTURE_EXTERNAL_TYPE(guest::Limits, member(low, unit("N")), member(high, unit("N")));

/// Keeps to its limits.
class SUTURE_COMPONENT() Fence : public suture::Device {
 public:
  explicit Fence(const guest::Limits& limits) : limits_(limits) {}
  const guest::Limits& limits() const { return limits_; }

 private:
  guest::Limits limits_;
};

}  // namespace shapes
