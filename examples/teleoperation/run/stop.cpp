#include "run/stop.h"

#include <suture/base/errors.h>

#include <algorithm>

namespace demo {

std::optional<Moment> parseStop(const std::string& text, suture::Duration runLength) {
  if (text.empty()) return std::nullopt;
  const std::string asked = "--stop " + text;
  const std::optional<Moment> moment = parseMoment(text);
  if (!moment) {
    throw suture::SetupError(asked, "that is no moment", "Write for example 6s, or 6s+1500ms");
  }
  requireRoom(asked, *moment, runLength);
  return moment;
}

std::optional<Pressed> firstStop(const std::vector<robots::StopNews>& stops) {
  const auto isPress = [](const robots::StopNews& news) { return news.pressed; };
  const auto end = stops.end();
  const auto begun = std::find_if_not(stops.begin(), end, isPress);
  const auto pressed = std::find_if(begun, end, isPress);
  const auto released = std::find_if_not(pressed, end, isPress);
  if (pressed == end) return std::nullopt;
  return Pressed{pressed->stamp, released == end ? std::nullopt : std::optional(released->stamp)};
}

}  // namespace demo
