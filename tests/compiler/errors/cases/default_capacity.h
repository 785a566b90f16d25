#pragma once
#include <suture/annotate.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>
namespace demo {
struct SUTURE_TYPE() Lengths {
  SUTURE_FIELD(capacity(1, 1)) std::vector<std::string> longInside{"long"};
  SUTURE_FIELD(capacity(1)) std::optional<std::string> longHeld = "long";
  SUTURE_FIELD(capacity(2)) std::vector<double> repeated = std::vector<double>(3, 1.0);
  SUTURE_FIELD(capacity(2)) std::vector<double> counted = std::vector<double>(3);
  SUTURE_FIELD(capacity(2)) std::string spaces = std::string(3, ' ');
  SUTURE_FIELD(capacity(4)) std::array<std::string, 2> longThere{"some", "longer"};
  SUTURE_FIELD(capacity(2, 4)) std::vector<std::string> fits{"some", std::string(4, 'a')};
  SUTURE_FIELD(capacity(2, 3)) std::map<int, std::string> longValue{{1, "long"}};
  SUTURE_FIELD(capacity(2)) std::vector<double> open = {1, 2};
  SUTURE_FIELD(capacity(2)) std::string characters{'l', 'o', 'n', 'g'};
  SUTURE_FIELD(capacity(2, 3)) std::map<std::string, double> longKey{{"long", 1}};
  SUTURE_FIELD(capacity(8)) std::unordered_map<int, double> buckets{64};
};
}  // namespace demo
