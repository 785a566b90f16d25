#include "recorder/followed_time.h"

#include <algorithm>
#include <chrono>

#include "timing/seconds.h"

namespace robots {
namespace {

using suture::Time;

// A slave may be thought to have followed for at most this time without a record.
constexpr auto kLongestSilence = std::chrono::milliseconds(50);
// A teleoperation that waits for data for so long has not heard of a release.
constexpr auto kMoment = std::chrono::milliseconds(300);
// A slave may need this long until it follows again: arms get power and home, masters turn.
constexpr auto kRecovery = std::chrono::seconds(3);

double lengthOf(const Span& span) { return secondsBetween(span.begin, span.end); }

double lengthOf(const std::vector<Span>& spans) {
  double seconds = 0;
  for (const Span& span : spans) seconds += lengthOf(span);
  return seconds;
}

/// Returns what is left of the spans outside of `removed`.
std::vector<Span> without(const std::vector<Span>& spans, const Span& removed) {
  if (removed.end <= removed.begin) return spans;
  std::vector<Span> left;
  for (const Span& span : spans) {
    const Span before{span.begin, std::min(span.end, removed.begin)};
    const Span after{std::max(span.begin, removed.end), span.end};
    if (before.begin < before.end) left.push_back(before);
    if (after.begin < after.end) left.push_back(after);
  }
  return left;
}

/// Returns the span with what the slave needed after it.
Span withRecovery(const Span& span, const std::vector<Span>& missing) {
  const auto found = std::find_if(missing.begin(), missing.end(), [&](const Span& one) {
    return one.begin <= span.end && span.end < one.end;
  });
  if (found == missing.end()) return span;
  return {span.begin, std::min(found->end, span.end + kRecovery)};
}

}  // namespace

std::vector<Span> clutched(const std::vector<ClutchNews>& news, Time end) {
  std::vector<Span> spans;
  bool isPressed = false;
  for (const ClutchNews& one : news) {
    const bool goesOn = !spans.empty() && one.stamp - spans.back().end < kMoment;
    if (one.pressed && !isPressed && goesOn) spans.back().end = end;
    if (one.pressed && !isPressed && !goesOn) spans.push_back({one.stamp, end});
    if (!one.pressed && isPressed) spans.back().end = one.stamp;
    isPressed = one.pressed;
  }
  return spans;
}

void FollowedTime::add(Time stamp, bool follows) {
  if (!first_) {
    if (!follows) return;
    first_ = last_ = stamp;
  }
  if (!follows || stamp - last_ > kLongestSilence) {
    const bool goesOn = !missing_.empty() && missing_.back().end == last_;
    if (!goesOn) missing_.push_back({last_, last_});
    missing_.back().end = stamp;
  }
  last_ = stamp;
}

FollowedShare FollowedTime::until(Time end, const std::vector<Span>& excused) const {
  if (!first_) return {};
  std::vector<Span> missing = missing_, required{{*first_, end}};
  if (end - last_ > kLongestSilence) missing.push_back({last_, end});
  missing = without(missing, {end, Time::max()});  // it need not follow after the end
  for (const Span& one : excused) {
    const Span span = withRecovery(one, missing_);
    missing = without(missing, span);
    required = without(required, span);
  }
  const double seconds = lengthOf(required);
  if (seconds <= 0 || missing.empty()) return {.share = 1};
  const Span longest = *std::max_element(
      missing.begin(), missing.end(),
      [](const Span& one, const Span& other) { return lengthOf(one) < lengthOf(other); });
  return {.share = 1 - lengthOf(missing) / seconds,
          .missing_from = secondsBetween(*first_, longest.begin),
          .missing_until = secondsBetween(*first_, longest.end)};
}

}  // namespace robots
