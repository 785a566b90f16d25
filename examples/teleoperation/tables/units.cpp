#include "tables/units.h"

#include <fmt/format.h>

#include <chrono>

namespace demo {

std::string milliseconds(suture::Duration duration) {
  const double number = std::chrono::duration<double, std::milli>(duration).count();
  const int decimals = number < 99.995 ? 2 : number < 999.95 ? 1 : 0;
  return fmt::format("{:.{}f}", number, decimals);
}

std::string microseconds(suture::Duration duration) {
  return fmt::format("{:.0f}", std::chrono::duration<double, std::micro>(duration).count());
}

std::string counted(std::size_t number, const std::string& noun) {
  const char* const ending = number == 1 ? "" : noun.back() == 's' ? "es" : "s";
  return fmt::format("{} {}{}", number, noun, ending);
}

}  // namespace demo
