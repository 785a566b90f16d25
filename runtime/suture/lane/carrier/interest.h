#pragma once
// Interest says what a client wants to hear of, as this process numbers it.

#include <suture/component/contract/interface_info.h>
#include <suture/rt/state/row_columns.h>

#include <cstdint>

namespace suture {

/// It takes the place of the one before.
struct Interest {
  std::uint32_t number = 0;  ///< of the subscriptions of this connection, from 1; 0: not counted
  EventSet events;           ///< that the client wants
  EventSet joining;       ///< of these what it wants anew: the last value first, if it is latched
  rt::ColumnSet columns;  ///< of the state that it reads
};

}  // namespace suture
