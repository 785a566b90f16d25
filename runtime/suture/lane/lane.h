#pragma once
// This names the lane that is asked for.

#include <string>

namespace suture {

/// Names a lane: one of the runtime's own, or one that Manager::addLane() has brought. Whether
/// there is one of that name is found when a connection is made.
struct Lane {
  static const Lane Auto;   ///< `local` within the process; to another process the fastest that
                            ///< fits
  static const Lane Shm;    ///< memory that two processes of one machine share
  static const Lane Frame;  ///< frames on a socket and thread of their own
  static const Lane Rpc;    ///< Cap'n Proto RPC

  std::string name;

  friend bool operator==(const Lane&, const Lane&) = default;
};

inline const Lane Lane::Auto{"auto"};
inline const Lane Lane::Shm{"shm"};
inline const Lane Lane::Frame{"frame"};
inline const Lane Lane::Rpc{"rpc"};

inline std::string toString(const Lane& lane) { return lane.name; }

}  // namespace suture
