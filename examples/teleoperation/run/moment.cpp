#include "run/moment.h"

#include <suture/base/errors.h>

#include <chrono>
#include <regex>

namespace demo {
namespace {

using namespace std::chrono_literals;
using suture::Duration;

constexpr Duration kReady = 2s;
constexpr Duration kShortest = 1s;
constexpr Duration kJudgedAfter = 3s;

/// Returns a duration that parseMoment() has accepted: it has at most six digits, which fit any
/// duration.
Duration durationOf(const std::string& number, const std::string& unit) {
  const double seconds = std::stod(number) * (unit == "ms" ? 1e-3 : 1);
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

std::optional<Moment> parseMoment(const std::string& text) {
  static const std::regex form(
      R"((\d{1,6}(?:\.\d{1,6})?)(ms|s)?(?:\+(\d{1,6}(?:\.\d{1,6})?)(ms|s)?)?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) return std::nullopt;
  Moment moment{.at = durationOf(parts[1], parts[2])};
  if (parts[3].matched) moment.length = durationOf(parts[3], parts[4]);
  return moment;
}

void requireRoom(const std::string& asked, const Moment& moment, Duration runLength) {
  if (moment.at < kReady) {
    throw suture::SetupError(asked, "the arms get ready within the first 2 s, and nobody moves yet",
                             "Let it be later");
  }
  if (moment.length < kShortest) {
    throw suture::SetupError(asked, "that is over before anybody could tell who holds",
                             "Let it last for at least one second");
  }
  if (moment.at + moment.length + kJudgedAfter > runLength) {
    throw suture::SetupError(asked, "the run ends less than 3 s after that is over",
                             "Let it be sooner, or let --seconds be more");
  }
}

}  // namespace demo
