#pragma once
// This says how the keys of a terminal move a hand.

#include <suture/base/time.h>

#include <Eigen/Core>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "person/hand_input.h"

namespace robots {

struct KeyMotionRates {
  double speed = 0.02;         ///< m/s
  double turning_speed = 0.3;  ///< rad/s
  /// A terminal repeats a key that is held, and does not say when it is released.
  suture::Duration hold = std::chrono::milliseconds(150);
};

/// One thread; never allocates.
///
/// While a key repeats, the hand moves at constant speed. It stops when the key's last repeat is
/// `hold` ago, when the key of the opposite direction comes, and at once at a space. One key
/// presses the clutch and another one releases it, because a terminal repeats a key that is held,
/// and does not say for how long. Keys that have no meaning, and what a terminal sends for arrows
/// and function keys, are ignored.
class KeyMotion {
 public:
  /// Says for people what each key does.
  static constexpr std::string_view kHelp =
      "keys, backward and forward: a d along x, s w along y, f r along z; k i about x, j l about "
      "y, "
      "u o about z; c closes the gripper, v opens it; x presses the clutch, z releases it; space "
      "stops. Hold a key to go on";

  explicit KeyMotion(const KeyMotionRates& rates) : rates_(rates) {}

  /// Says that a key has come, by ascending `now`.
  void take(char key, suture::Time now);
  /// Forgets all keys.
  void stop() { ends_ = {}; }

  HandInput at(suture::Time now) const;
  /// Returns true if the clutch is pressed.
  bool clutch() const { return clutch_; }

 private:
  static constexpr std::size_t kKeys = 12;
  /// Says which part of an escape sequence is still to come.
  enum class Escape : std::uint8_t { None, Second, Final };

  bool isOfEscape(char key, suture::Time now);

  const KeyMotionRates rates_;
  std::array<suture::Time, kKeys> ends_{};  // when the motion of each direction ends
  std::optional<double> opening_;
  bool clutch_ = false;
  Escape escape_ = Escape::None;
  suture::Time escaped_;  // when the sequence began
};

}  // namespace robots
