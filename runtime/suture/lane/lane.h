#pragma once
// This names the lane that is asked for.

#include <string>
#include <string_view>

namespace suture {

/// Names a lane: one of the runtime's own, or one that Manager::addLane() has brought.
struct Lane {
  static const Lane Auto;   ///< `local` within the process; to another process the fastest that
                            ///< fits
  static const Lane Shm;    ///< memory that two processes of one machine share
  static const Lane Frame;  ///< frames on a socket and thread of their own
  static const Lane Rpc;    ///< Cap'n Proto RPC

  std::string_view name;  ///< lives as long as the program

  friend bool operator==(Lane, Lane) = default;
};

inline constexpr Lane Lane::Auto{"auto"};
inline constexpr Lane Lane::Shm{"shm"};
inline constexpr Lane Lane::Frame{"frame"};
inline constexpr Lane Lane::Rpc{"rpc"};

inline std::string toString(Lane lane) { return std::string(lane.name); }

/// Returns the runtime's own lane of that name; any other text means Lane::Auto.
Lane laneNamed(std::string_view name);

}  // namespace suture
