#pragma once
#include <suture/annotate.h>

#include <tuple>
#include <utility>
namespace demo {
struct SUTURE_TYPE() Force {
  double x = 0;
};
struct SUTURE_TYPE() Torque {
  double x = 0;
};
struct SUTURE_TYPE() ForceAndTorque {
  double x = 0;
};
struct SUTURE_TYPE() Nested {
  std::tuple<std::pair<double, double>, double, double> first;
  std::tuple<std::tuple<double, double, double>, double> second;
  std::tuple<std::tuple<double, double>, double, double> asTheFirst;
};
class SUTURE_INTERFACE() Contract {
 public:
  virtual ~Contract() = default;
  SUTURE_COMMAND() virtual std::pair<ForceAndTorque, double> measured() const = 0;
  SUTURE_EVENT() suture::EventOf<std::tuple<Force, Torque, double>> felt;
};
}  // namespace demo
