#pragma once
// This is one system under the faults that one seed chooses.

#include <suture/testing/trace.h>

#include <cstdint>
#include <string>
#include <vector>

namespace explorer {

/// Tells what became of a world.
struct Outcome {
  std::string lane;
  std::string setup;                ///< lane and faults, for people
  std::vector<std::string> broken;  ///< rules of the history and of the clock that did not hold
  unsigned answered = 0;            ///< calls that were
  unsigned harms = 0;               ///< faults other than those of messages
  suture::Trace trace;
};

/// Runs one on a clock of its own. The calling thread must have none.
Outcome runWorld(std::uint64_t seed);

}  // namespace explorer
