#include "break.h"

#include <suture/base/errors.h>

#include <chrono>
#include <regex>

namespace demo {
namespace {

using namespace std::chrono_literals;
using suture::Duration;

constexpr Duration kShortest = 1s;
constexpr Duration kJudgedAfter = 3s;

/// As parseBreak() takes it: six digits at most, which fit any duration.
Duration durationOf(const std::string& number, const std::string& unit) {
  const double seconds = std::stod(number) * (unit == "ms" ? 1e-3 : 1);
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

void requireRoom(const std::string& asked, const Break& found, Duration runLength) {
  if (found.length < kShortest) {
    throw suture::SetupError(asked, "that is mended before anybody could tell who holds",
                             "Let it last for at least one second");
  }
  if (found.at + found.length + kJudgedAfter > runLength) {
    throw suture::SetupError(asked, "the run ends less than 3 s after that is mended",
                             "Break it sooner, or let --seconds be more");
  }
}

}  // namespace

std::optional<Break> parseBreak(const std::string& text, const Plan& plan, Duration runLength) {
  if (text.empty()) return std::nullopt;
  const std::string asked = "--break " + text;
  static const std::regex form(
      R"(([^@]+)@(\d{1,6}(?:\.\d{1,6})?)(ms|s)?(?:\+(\d{1,6}(?:\.\d{1,6})?)(ms|s)?)?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) {
    throw suture::SetupError(asked, "that names no process and moment",
                             "Write for example vision@4s, or vision@4s+1500ms");
  }
  plan.deployment().process(parts[1].str());  // throws if there is none
  if (!plan.needsManager()) {
    throw suture::SetupError(asked, "it is the only process, and talks to no other",
                             "Choose a topology of several processes, or leave --break out");
  }
  const Break found{parts[1], durationOf(parts[2], parts[3]),
                    parts[4].matched ? durationOf(parts[4], parts[5]) : kShortest,
                    plan.slavesDrivenAcross(parts[1])};
  requireRoom(asked, found, runLength);
  return found;
}

}  // namespace demo
