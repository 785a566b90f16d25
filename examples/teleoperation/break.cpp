#include "break.h"

#include <suture/base/errors.h>

#include <chrono>
#include <regex>

namespace demo {
namespace {

using namespace std::chrono_literals;
using suture::Duration;

constexpr Duration kUsualLength = 1s;
constexpr Duration kJudgedAfter = 3s;

Duration durationOf(const std::string& number, const std::string& unit) {
  const double seconds = std::stod(number) * (unit == "ms" ? 1e-3 : 1);
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

std::optional<Break> parseBreak(const std::string& text, const Plan& plan, Duration runLength) {
  if (text.empty()) return std::nullopt;
  const std::string asked = "--break " + text;
  static const std::regex form(R"(([^@]+)@([0-9.]+)(ms|s)?(?:\+([0-9.]+)(ms|s)?)?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) {
    throw suture::SetupError(asked, "that names no process and moment",
                             "Write for example vision@4s, or vision@4s+500ms");
  }
  plan.deployment().process(parts[1].str());  // throws if there is none
  const Break found{parts[1], durationOf(parts[2], parts[3]),
                    parts[4].matched ? durationOf(parts[4], parts[5]) : kUsualLength};
  if (found.at + found.length + kJudgedAfter > runLength) {
    throw suture::SetupError(asked, "the run ends less than 3 s after that is mended",
                             "Break it sooner, or let --seconds be more");
  }
  return found;
}

}  // namespace demo
