#pragma once
// These are coordinate frames: their names, and the numbers that stand for them in data.

#include <cstdint>
#include <string>
#include <string_view>

namespace suture {

/// Names a coordinate frame in data that control loops exchange, where a string would cost too
/// much. 0 names none.
using FrameId = std::uint32_t;

/// Any thread; never allocates. Returns the id of the frame `name`: its FNV-1a hash, or 0 for "".
/// Among a hundred frames of one system two share an id with a probability of one in a million.
constexpr FrameId frameId(std::string_view name) {
  if (name.empty()) return 0;
  FrameId hash = 2166136261u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash == 0 ? 1 : hash;
}

/// Says which frames the poses and vectors of an interface are in where their data do not say it. A
/// plain value of set-up code.
struct Frames {
  std::string reference;  ///< the frame in which they are given, "PSM1_base"; "": any
  std::string moving;     ///< the frame whose pose or motion they are, "PSM1_tip"; "": any

  bool operator==(const Frames&) const = default;
};

}  // namespace suture
