#pragma once
// This says which events and state a client wants, as this process numbers them.

#include <suture/component/contract/interface_info.h>
#include <suture/rt/state/row_columns.h>

#include <cstdint>

namespace suture {

/// Replaces the one before.
struct Interest {
  std::uint32_t number = 0;  ///< counts the subscriptions of this connection, from 1; 0: not
                             ///< counted
  EventSet events;           ///< that the client wants
  EventSet joining;          ///< those that it wants anew: the last value first, if it is latched
  rt::ColumnSet columns;     ///< the part of the state that it reads
};

}  // namespace suture
