#include <suture/deploy/number_option.h>

#include <chrono>
#include <cstdlib>
#include <sstream>

namespace suture {
namespace {

/// Returns true if `text` is a number in these limits, which NaN never is.
bool lies(const std::string& text, double least, double most) {
  char* after = nullptr;
  const double number = std::strtod(text.c_str(), &after);
  const bool whole = !text.empty() && after == text.c_str() + text.size();
  return whole && number >= least && number <= most;
}

}  // namespace

std::string whyNotNumber(const std::string& text, double least, double most) {
  if (lies(text, least, most)) return "";
  std::ostringstream why;
  why << "Give a number from " << least << " to " << most;
  return why.str();
}

std::string whyNotTime(const std::string& text) {
  return lies(text, 1e-3, 1e9) ? "" : "Give a time from 1 ms to 1e9 s";
}

Duration fromSeconds(double seconds) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace suture
