#pragma once
// These are the parts of `suture-bench network`. Each measures, leaves its figures in the report
// and returns a table. Nothing else may run in this process meanwhile.

#include <string>

#include "bench/figures/report.h"
#include "bench/network/options.h"

namespace bench {

/// "shm", "frame.unix", "frame.tcp", "frame.tls", "rpc.unix", "rpc.tcp", "rpc.tls": PoseSample from
/// task to task and back, between two processes; "raw.shm", "raw.unix", "raw.tcp": as many bytes
/// without Suture, in the same run; the ratios, that of TLS to raw TCP. "frame.encoded": `frame` as
/// between builds that differ, "frame.encoded.builds": to that between equal ones.
std::string roundTripRows(const NetworkOptions& options, Report& report);

/// "mirror_read": a read command whose provider is in another process, by shared memory;
/// "local_read": the same in this one.
std::string mirrorRows(const NetworkOptions& options, Report& report);

/// Measures "allocations.shm.client", "allocations.shm.arm", ...: what the task threads at both
/// ends of a complete CRTK arm allocate in steady state, with no wait in it;
/// "allocations.frame.lane": what the lane threads of both do; "allocations.shm.lane_threads": how
/// many there are.
std::string allocationRows(const NetworkOptions& options, Report& report);

/// Measures "fan_out.raw", "fan_out.shm", ...: the ages of an event when its handlers run, at 1 kHz
/// to 64 interfaces of one task in another process, ".load": of both sides; ".ratio": of the 99th
/// percentiles; "fan_out.shm.processes", ...: to 16 processes.
std::string networkFanOutRows(const NetworkOptions& options, Report& report);

/// Measures "images.shm.alone", "images.shm.beside", ...: how old goals at 1 kHz are when they are
/// executed, without and with pairs of images of 2 x 921,600 bytes, 15 a second, on the same lane
/// between the same processes; ".growth.p50", ".growth.p99": the difference; ".seen": how many
/// pairs came; ".lost": if their connection, which bears 100 ms of silence, was lost meanwhile.
std::string imageRows(const NetworkOptions& options, Report& report);

/// Measures "idle.shm.load.ratio", "idle.frame.wake_ups.ratio", "idle.rpc.bytes.ratio", ...: what
/// 256 connections between two processes cost in a second in which nothing is sent, to what one
/// does; ".descriptors", ".memory", ".further": what each but the first takes of both processes, of
/// the client's memory beyond its queues and rows, and of time.
std::string idleRows(const NetworkOptions& options, Report& report);

/// Measures "sleeping.10.wake_ups", ...: how often the threads of 10, 100 and 1,000 components
/// without a connection wake up within the window; ".descriptors": of each.
std::string sleepingRows(const NetworkOptions& options, Report& report);

/// Measures "sizes.shm.small", "sizes.frame.unix.small", "sizes.frame.tcp.small",
/// "sizes.rpc.unix.small", "sizes.rpc.tcp.small": 120 bytes in a type with as much room, from task
/// to task and back between two processes; ".roomy": the same in a type with room for 1 MiB,
/// ".room": the ratio; ".large": 1 MiB in it, ".large.ratio": to as many bytes over a bare socket
/// in the same run, Unix for `shm`.
std::string sizeRows(const NetworkOptions& options, Report& report);

/// "streams.shm", "streams.frame.unix", ...: how many poses a second go one way between two
/// processes, each on a processor of its own, ".lost": how many of them did not arrive;
/// "streams.raw.unix", "streams.raw.tcp": as many bytes over a bare socket, one send each.
std::string streamRows(const NetworkOptions& options, Report& report);

/// "connect.shm", ...: from nothing to a connection; "killed.shm", "silence.shm", ...: until a
/// killed or a stopped process counts as lost, ".ratio": to the bound on silence; "threads.shm".
std::string linkTimeRows(const NetworkOptions& options, Report& report);

/// "survivors.shm.skipped", ...: the share of its periods that a client at 1 kHz skips while its
/// arm's process is killed and stopped again and again; "survivors.bare.skipped": that of a bare
/// loop beside the same faults, by turns with it; ".excess": the difference; ".longest": the
/// client's longest cycle; ".faults". Both loops are SCHED_FIFO where this process may.
std::string survivorRows(const NetworkOptions& options, Report& report);

}  // namespace bench
