#include "person/key_motion.h"

namespace robots {
namespace {

// Each direction stands beside its opposite, and the pairs are in the order of the axes.
constexpr std::string_view kDirections = "adswfrkijluo";
constexpr std::size_t kTurns = 6;  // the first of those that turn
constexpr char kEscape = '\x1b';
// A terminal sends a sequence at once; what comes later than this is a key that was pressed.
constexpr suture::Duration kSequence = std::chrono::milliseconds(50);

}  // namespace

void KeyMotion::take(char key, suture::Time now) {
  static_assert(kDirections.size() == kKeys);
  if (isOfEscape(key, now)) return;
  if (key == ' ') return stop();
  if (key == 'c') opening_ = 0;
  if (key == 'v') opening_ = 1;
  if (key == 'x') clutch_ = true;
  if (key == 'z') clutch_ = false;
  const std::size_t direction = kDirections.find(key);
  if (direction == std::string_view::npos) return;
  ends_[direction] = now + rates_.hold;
  ends_[direction ^ 1U] = {};
}

// Returns true for a key of an escape sequence. ESC [ or ESC O, any number of parameters, and a
// letter or ~ is an arrow or a function key. ESC and a letter is that letter with the key Alt.
bool KeyMotion::isOfEscape(char key, suture::Time now) {
  const Escape before = now - escaped_ < kSequence ? escape_ : Escape::None;
  const bool isFinal = key >= '@' && key <= '~';
  if (key == kEscape) {
    escape_ = Escape::Second;
    escaped_ = now;
  } else if (before == Escape::Second) {
    escape_ = key == '[' || key == 'O' ? Escape::Final : Escape::None;
  } else if (isFinal) {
    escape_ = Escape::None;
  }
  return before != Escape::None || key == kEscape;
}

HandInput KeyMotion::at(suture::Time now) const {
  HandInput input;
  input.opening = opening_;
  for (std::size_t i = 0; i < kKeys; ++i) {
    if (now >= ends_[i]) continue;
    const double sign = i % 2 == 0 ? -1 : 1;
    const auto axis = static_cast<Eigen::Index>(i / 2 % 3);
    if (i < kTurns) {
      input.velocity[axis] = sign * rates_.speed;
    } else {
      input.angular_velocity[axis] = sign * rates_.turning_speed;
    }
  }
  return input;
}

}  // namespace robots
