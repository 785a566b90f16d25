#include "compiler/check/units.h"

#include <algorithm>
#include <array>

#include "compiler/model/nearest.h"

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

}  // namespace

bool isKnownUnit(std::string_view symbol) {
  return std::find(kUnits.begin(), kUnits.end(), symbol) != kUnits.end();
}

std::string nearestUnit(std::string_view symbol) {
  return std::string(model::nearest(symbol, kUnits));
}

}  // namespace suture::compiler::check
