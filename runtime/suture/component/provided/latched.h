#pragma once
// This is where a provided interface keeps the last value of an event.

#include <suture/component/provided/event_emission.h>
#include <suture/rt/state/state_table.h>

#include <array>
#include <atomic>

namespace suture {

/// Holds the last value of a latched event as the only column of a table.
struct EventEmission::Latched {
  explicit Latched(const EventInfo& event)
      : values(std::array{event.payloadSize}, kRows, rt::ColumnSet{event.sharedPayload},
               rt::StateTable::Readers::Here) {}

  static constexpr unsigned kRows = 4;
  rt::StateTable values;
  std::atomic_flag keeping = ATOMIC_FLAG_INIT;
};

}  // namespace suture
