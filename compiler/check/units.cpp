#include "compiler/check/units.h"

#include <algorithm>
#include <array>

#include "compiler/model/nearest.h"

namespace suture::compiler::check {
namespace {

using std::string_view;

// Units are spelled as in UCUM: '.' multiplies, '/' divides by the next factor, digits are powers.

// These take a prefix. They are the units of SI, of which CRTK, ROS REP-103 and OpenIGTLink use
// some, and a few that people use beside SI.
constexpr std::array<string_view, 32> kMetric{
    "m", "g", "s", "A", "K",   "mol", "cd", "rad", "sr", "Hz", "N",  "Pa", "J", "W", "C",   "V",
    "F", "H", "T", "S", "Ohm", "Wb",  "lm", "lx",  "Bq", "Gy", "Sv", "l",  "L", "B", "bar", "eV"};
// These take no prefix.
constexpr std::array<string_view, 12> kPlain{"1",   "%",    "min", "h",  "d",   "deg",
                                             "Cel", "degC", "rev", "px", "bit", "count"};
constexpr std::array<string_view, 11> kPrefixes{"p", "n", "u", "m", "c", "d",
                                                "h", "k", "M", "G", "T"};

// A unit that is spelled wrongly probably means one of these.
constexpr std::array<string_view, 74> kCommon{
    "1",     "%",       "m",     "mm",        "um",     "nm",     "km",     "m2",   "mm2",   "m3",
    "mm3",   "l",       "ml",    "rad",       "mrad",   "deg",    "sr",     "s",    "ms",    "us",
    "ns",    "min",     "h",     "Hz",        "kHz",    "MHz",    "m/s",    "km/h", "mm/s",  "m/s2",
    "mm/s2", "m/s3",    "rad/s", "deg/s",     "rad/s2", "deg/s2", "rad/s3", "1/s",  "1/min", "kg",
    "g",     "mg",      "kg.m2", "kg/m3",     "N",      "mN",     "kN",     "N.m",  "mN.m",  "N/m",
    "N/mm",  "N.m/rad", "N.s/m", "N.m.s/rad", "Pa",     "kPa",    "MPa",    "bar",  "J",     "W",
    "kW",    "V",       "mV",    "A",         "mA",     "Ohm",    "F",      "H",    "T",     "K",
    "Cel",   "px",      "B",     "bit"};

template <std::size_t n>
bool has(const std::array<string_view, n>& units, string_view symbol) {
  return std::find(units.begin(), units.end(), symbol) != units.end();
}

bool isUnit(string_view symbol) {
  return has(kPlain, symbol) || has(kMetric, symbol) ||
         std::any_of(kPrefixes.begin(), kPrefixes.end(), [&](string_view prefix) {
           return symbol.starts_with(prefix) && has(kMetric, symbol.substr(prefix.size()));
         });
}

/// Tells if the text is a unit, which may have a power: "m", "m2", "s-1".
bool isFactor(string_view text) {
  if (isUnit(text)) return true;
  const std::size_t sign = text.find_last_not_of("123456789");
  if (sign == string_view::npos || text.size() - sign != 2) return false;
  const bool isNegative = text[sign] == '-';
  if (!isNegative && text.back() == '1') return false;
  return isUnit(text.substr(0, sign + (isNegative ? 0 : 1)));
}

}  // namespace

bool isKnownUnit(std::string_view symbol) {
  for (;;) {
    const std::size_t end = symbol.find_first_of("./");
    if (!isFactor(symbol.substr(0, end))) return false;
    if (end == symbol.npos) return true;
    symbol.remove_prefix(end + 1);
  }
}

std::optional<std::string> nearestUnit(std::string_view symbol) {
  // A person who writes "Nm" forgot the point and does not mean "m", which is as near by letters.
  const auto* pointed = std::find_if(kCommon.begin(), kCommon.end(), [&](string_view unit) {
    std::string plain(unit);
    std::erase(plain, '.');
    return plain == symbol;
  });
  const auto meant =
      pointed != kCommon.end() ? std::optional(*pointed) : model::nearest(symbol, kCommon);
  return meant ? std::optional<std::string>(*meant) : std::nullopt;
}

}  // namespace suture::compiler::check
