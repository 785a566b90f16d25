#include "tables/units.h"

#include <fmt/format.h>

#include <chrono>

namespace demo {

std::string milliseconds(suture::Duration duration) {
  return fmt::format("{:.2f}", std::chrono::duration<double, std::milli>(duration).count());
}

std::string microseconds(suture::Duration duration) {
  return fmt::format("{:.0f}", std::chrono::duration<double, std::micro>(duration).count());
}

}  // namespace demo
