#pragma once
// A contract whose answers have ranges.

#include <suture/annotate.h>

#include <cstdint>
#include <limits>

namespace contracts {

class SUTURE_INTERFACE() Share {
 public:
  virtual ~Share() = default;
  SUTURE_COMMAND() SUTURE_FIELD(range(0, 1)) virtual double share() const = 0;
  SUTURE_COMMAND() SUTURE_FIELD(range(0, 1)) virtual std::int32_t shares(bool all) const = 0;
  SUTURE_COMMAND() SUTURE_FIELD(range(0, 1)) virtual double take(double wanted) = 0;
  SUTURE_COMMAND()
  SUTURE_FIELD(range(0, std::numeric_limits<double>::infinity()))
  virtual double reach() const = 0;
};

}  // namespace contracts
