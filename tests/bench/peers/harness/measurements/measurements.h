#pragma once
// Each measurement prints its figures: times are in us unless the name says otherwise.

#include "harness/control_block.h"
#include "harness/options.h"
#include "harness/peer.h"

namespace peers {

/// Sends a pose there and back, `count` times, and counts the processor time, the context switches
/// and the loopback traffic of both processes.
void measureRoundTrips(Peer& peer, const Options& options, ControlBlock& control);
/// Poses go one way as fast as there is room, `count` of them or as many as `seconds` permit.
void measureStream(Peer& peer, const Options& options, ControlBlock& control);
/// Numbers in bulk go there and back; each size has a line.
void measurePayloads(Peer& peer, const Options& options, ControlBlock& control);
/// `count` poses go to all servers at 1 kHz; the time of each ends when the last server has it.
void measureFanOut(Peer& peer, const Options& options, ControlBlock& control);
/// A pose becomes bytes and a pose again within this process; in ns.
void measureConversion(Peer& peer, const Options& options);

}  // namespace peers
