#pragma once
#include <suture/annotate.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>
namespace demo {
struct SUTURE_TYPE() Limits {
  SUTURE_FIELD(range(1, 2)) double low = 0.5;
  SUTURE_FIELD(range(1, 2)) int unsaid;
  SUTURE_FIELD(range(-1, 2)) double high = std::numeric_limits<double>::infinity();
  SUTURE_FIELD(range(1, 2)) double within = 2;
  SUTURE_FIELD(range(1, 2)) std::optional<double> none;
  SUTURE_FIELD(range(1, 2)) std::array<double, 2> zeros;
  SUTURE_FIELD(range(1, 2)) Eigen::Vector3d nowhere;
  SUTURE_FIELD(range(1, 2)) std::array<double, 2> ones{1, 1};
  SUTURE_FIELD(range(1, 2), capacity(4)) std::vector<double> none_at_all;
};
struct SUTURE_TYPE() Several {
  SUTURE_FIELD(range(0, 1)) std::array<double, 2> array{5, 5};
  SUTURE_FIELD(range(1, 2)) std::array<double, 2> rest{1};
  SUTURE_FIELD(range(0, 1)) std::int32_t plain[3] = {1, 0, -1};
  SUTURE_FIELD(range(0, 1)) std::array<std::array<float, 1>, 2> nested{{{1}, {2}}};
  SUTURE_FIELD(range(0, 1), capacity(2)) std::vector<double> listed{0, 5};
  SUTURE_FIELD(range(0, 1), capacity(2)) std::vector<double> repeated = std::vector<double>(2, 3.0);
  SUTURE_FIELD(range(1, 2), capacity(2)) std::vector<double> counted = std::vector<double>(2);
  SUTURE_FIELD(range(0, 1)) std::optional<double> chosen = 7;
  SUTURE_FIELD(range(0, 1), capacity(2)) std::map<int, double> mapped{{1, 0.5}, {2, 1.5}};
};
struct SUTURE_TYPE() SeveralWithin {
  SUTURE_FIELD(range(0, 1)) std::array<double, 2> array{1};
  SUTURE_FIELD(range(0, 0.1)) std::array<float, 2> rounded{0.1F, 0.1F};
  SUTURE_FIELD(range(0, 1), capacity(2)) std::vector<double> repeated = std::vector<double>(2, 1.0);
  SUTURE_FIELD(range(1, 2), capacity(2)) std::vector<double> empty = std::vector<double>();
  SUTURE_FIELD(range(1, 2)) std::optional<double> chosen = 1.5;
  SUTURE_FIELD(range(1, 2)) std::optional<double> none = std::nullopt;
  SUTURE_FIELD(range(0, 1), capacity(2)) std::map<int, double> mapped{{7, 0.5}, {9, 1}};
};
struct SUTURE_TYPE() FromTemplate {
  template <class T = double>
  FromTemplate(T = {}) : shown(1.5), low(0.5) {}
  SUTURE_FIELD(range(1, 2)) double shown;
  SUTURE_FIELD(range(1, 2)) double low;
  SUTURE_FIELD(range(1, 2)) double declared = 1;
};
struct Foreign {
  template <class T = double>
  Foreign(T late = {}) : given(late) {}
  double given;
};
SUTURE_EXTERNAL_TYPE(Foreign, member(given, range(1, 2)));
struct Listed {
  Listed() : low(0.5), within(1.5) {}
  double low, within;
};
SUTURE_EXTERNAL_TYPE(Listed, member(low, range(1, 2)), member(within, range(1, 2)));
struct SUTURE_TYPE() AtItsBound {
  SUTURE_FIELD(range(0, 0.1)) float rounded = 0.1F;
  SUTURE_FIELD(range(0, 0.7)) std::optional<float> held = 0.7;
  SUTURE_FIELD(range(0, 1)) std::optional<int> cut = 1.5;
};
}  // namespace demo
