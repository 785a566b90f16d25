#pragma once
// These types were shipped first.

#include <suture/annotate.h>

#include <Eigen/Core>
#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace evolution {

enum class SUTURE_TYPE() Mode { Off, On };

struct SUTURE_TYPE() Sample {
  SUTURE_FIELD(unit("m")) double x = 0;
  std::int32_t count = 7;
  SUTURE_FIELD(capacity(16)) std::string label;
  SUTURE_FIELD(capacity(4)) std::vector<double> values;
  Mode mode = Mode::Off;
  std::chrono::milliseconds period{0};
  std::chrono::steady_clock::time_point seen;
  std::array<float, 2> pair{};
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double gone = 0;
};

class SUTURE_INTERFACE() Feed {
 public:
  virtual ~Feed() = default;
  SUTURE_COMMAND() virtual void put(const Sample& sample, double speed) = 0;
  SUTURE_COMMAND() virtual Mode mode() const = 0;
  SUTURE_EVENT(name("moved")) suture::EventOf<Sample> moved_event;
};

/// Does not carry a Sample.
class SUTURE_INTERFACE() Switch {
 public:
  virtual ~Switch() = default;
  SUTURE_COMMAND() virtual void toggle() = 0;
};

}  // namespace evolution
