#include "compiler/check/units.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace suture::compiler::check {
namespace {

// SI and what robots use beside it, spelled as in UCUM: '.' multiplies, '/' divides, digits are
// powers.
constexpr std::array<std::string_view, 73> kUnits{
    "1",       "%",     "m",         "mm",     "um",     "nm",     "km",  "m2",    "mm2",  "m3",
    "mm3",     "l",     "ml",        "rad",    "mrad",   "deg",    "sr",  "s",     "ms",   "us",
    "ns",      "min",   "h",         "Hz",     "kHz",    "MHz",    "m/s", "mm/s",  "m/s2", "mm/s2",
    "m/s3",    "rad/s", "deg/s",     "rad/s2", "deg/s2", "rad/s3", "1/s", "1/min", "kg",   "g",
    "mg",      "kg.m2", "kg/m3",     "N",      "mN",     "kN",     "N.m", "mN.m",  "N/m",  "N/mm",
    "N.m/rad", "N.s/m", "N.m.s/rad", "Pa",     "kPa",    "MPa",    "bar", "J",     "W",    "kW",
    "V",       "mV",    "A",         "mA",     "Ohm",    "F",      "H",   "T",     "K",    "Cel",
    "px",      "B",     "bit"};

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

bool isKnownUnit(std::string_view symbol) {
  return std::find(kUnits.begin(), kUnits.end(), symbol) != kUnits.end();
}

std::string nearestUnit(std::string_view symbol) {
  return std::string(*std::min_element(kUnits.begin(), kUnits.end(), [&](auto a, auto b) {
    return distance(symbol, a) < distance(symbol, b);
  }));
}

}  // namespace suture::compiler::check
