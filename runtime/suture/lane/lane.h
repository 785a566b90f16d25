#pragma once
// How a connection travels.

#include <cstdint>
#include <string_view>

namespace suture {

/// What is asked for. A lane that cannot be had is replaced by the next slower one, and reports say
/// why.
enum class Lane : std::uint8_t {
  Auto,   ///< `local` within the process; to another one the fastest that fits: `shm`, `frame`,
          ///< `rpc`
  Shm,    ///< memory that two processes of one machine share, even within the process
  Frame,  ///< frames on a socket and a thread of their own, even within the process
  Rpc,    ///< Cap'n Proto RPC, even within the process
};

/// "auto", "shm", "frame", "rpc".
const char* toString(Lane lane);
/// Lane::Auto for any other text.
Lane laneNamed(std::string_view name);

}  // namespace suture
