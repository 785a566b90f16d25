#pragma once
// Slots with much room, of which little is used as a rule.

#include <suture/annotate.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace shapes {

/// A list within whatever holds this.
struct SUTURE_TYPE() Trace {
  std::uint32_t channel = 0;
  SUTURE_FIELD(capacity(100)) std::vector<double> samples;
  double gain = 1;
};

/// A large level in each place where one can be.
struct SUTURE_TYPE() Large {
  double first = 0;
  SUTURE_FIELD(capacity(300)) std::string text;
  SUTURE_FIELD(capacity(8)) std::string name;  ///< too small to tell what is used of it
  SUTURE_FIELD(capacity(5)) std::vector<Trace> traces;
  SUTURE_FIELD(capacity(20, 30)) Eigen::MatrixXf image;
  Trace inner;
  std::optional<Trace> maybe;
  SUTURE_FIELD(capacity(40)) std::tuple<std::int8_t, Trace, std::vector<std::int64_t>> both;
  SUTURE_FIELD(capacity(50)) std::map<std::uint16_t, double> gains;
  std::array<Trace, 2> pair;  ///< travels whole
  SUTURE_FIELD(capacity(70))
  std::variant<std::monostate, Trace, std::vector<float>> choice;  ///< travels whole
  std::int64_t last = 0;
};

/// Carries them as arguments, results and payloads.
class SUTURE_INTERFACE() Recorder {
 public:
  virtual ~Recorder() = default;
  SUTURE_COMMAND()
  virtual void keep(SUTURE_FIELD(capacity(64)) const std::vector<double>& values,
                    const Large& rest) = 0;
  SUTURE_COMMAND() virtual void rename(SUTURE_FIELD(capacity(8)) const std::string& name) = 0;
  SUTURE_COMMAND() virtual const Large& kept() const = 0;
  SUTURE_EVENT(name("heard")) suture::EventOf<Trace> heard_event;
  SUTURE_EVENT(name("said")) suture::EventOf<std::int32_t, Large> said_event;
};

}  // namespace shapes
