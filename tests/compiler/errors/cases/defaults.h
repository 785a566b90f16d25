#pragma once
#include <suture/annotate.h>

#include <Eigen/Core>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>
namespace demo {
int later();
struct SUTURE_TYPE() Fields {
  int unknown = later();
  std::chrono::seconds pause{later()};
  std::chrono::nanoseconds ever = std::chrono::nanoseconds::max();
  std::chrono::hours longer = std::chrono::hours::max();
  std::chrono::steady_clock::time_point never = std::chrono::steady_clock::time_point::max();
  double nothing = std::numeric_limits<double>::quiet_NaN();
  double noLimit = std::numeric_limits<double>::infinity();
  std::string name = std::string(later(), 'a');
  int braces{};
};
struct SUTURE_TYPE() Many {
  std::array<double, 2> both{0, NAN};
  Eigen::Vector3d axis{0, std::numeric_limits<double>::quiet_NaN(), 1};
  Eigen::Vector2d gone = Eigen::Vector2d::Constant(NAN);
  SUTURE_FIELD(capacity(4)) std::vector<double> some = {1, -NAN};
  std::optional<double> perhaps = NAN;
  SUTURE_FIELD(capacity(4)) std::string word = "words";
  SUTURE_FIELD(capacity(2)) std::vector<int> three{1, 2, 3};
  SUTURE_FIELD(capacity(2)) std::vector<int> two{1, 2};
  SUTURE_FIELD(capacity(5)) std::string all = "words";
};
struct SUTURE_TYPE() InBody {
  InBody() { number = changed = 7; }
  int number;
  int changed = 1;
  int shown = 7;
};
struct SUTURE_TYPE() InMethod {
  InMethod() { reset(); }
  void reset() { number = 7; }
  int number = 1;
};
struct SUTURE_TYPE() Elsewhere {
  Elsewhere();
  int number;
};
struct SUTURE_TYPE() HandedOver {
  HandedOver() : HandedOver(7) {}
  explicit HandedOver(int n) : number(n) {}
  int number = 1;
};
struct SUTURE_TYPE() InList {
  InList() : number(7), late(later()), zero() {}
  int number, late, zero;
};
struct SUTURE_TYPE() InTemplate {
  template <class T = int>
  InTemplate(T late = {}) : number(7), given(late) {}
  int number, given;
};
template <class T>
struct SUTURE_TYPE() Box {
  T value{};
  int late = later();
  int early = 7;
};
using IntBox = Box<int>;
}  // namespace demo
