#pragma once
// These types came after those of v1: they have each edit that the lock allows.

#include <suture/annotate.h>

#include <Eigen/Core>
#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace evolution {

enum class SUTURE_TYPE() Mode { On, Off, Fast };  // reordered, one more

struct SUTURE_TYPE() Sample {
  double weight = 2.5;                           // new, with a default, and first
  std::int32_t count = 9;                        // another initialiser: the wire keeps the first
  SUTURE_FIELD(capacity(32)) std::string label;  // a wider bound
  Mode mode = Mode::Off;
  std::chrono::milliseconds period{0};
  SUTURE_FIELD(capacity(4)) std::vector<double> values;
  std::chrono::steady_clock::time_point seen;
  SUTURE_FIELD(unit("m"), was("x")) double east = 0;  // renamed
  std::array<float, 2> pair{};
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  SUTURE_FIELD(capacity(8)) std::string note;  // new, without a default
};

class SUTURE_INTERFACE() Feed {
 public:
  virtual ~Feed() = default;
  SUTURE_COMMAND() virtual Mode mode() const = 0;
  SUTURE_COMMAND() virtual void clear() = 0;                                            // new
  SUTURE_COMMAND() virtual void put(const Sample& sample, double speed, bool now) = 0;  // one more
  SUTURE_EVENT(name("moved")) suture::EventOf<Sample> moved_event;
};

/// Does not carry a Sample.
class SUTURE_INTERFACE() Switch {
 public:
  virtual ~Switch() = default;
  SUTURE_COMMAND() virtual void toggle() = 0;
};

}  // namespace evolution
