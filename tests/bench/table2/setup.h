#pragma once
// This is what one measurement of a loop is.

#include <suture/base/time.h>
#include <suture/lane/lane.h>
#include <suture/rt/scheduling.h>

#include <cstddef>
#include <string>

namespace bench {

enum class Loop {
  Scs,     ///< server, client, server: a value is read, written back, and measured by the server
  Csc,     ///< client, server, client: a value is written, raised as an event, and measured by the
           ///< client
  OneWay,  ///< client, server: a value is written, and measured by the server; both read one clock
};
enum class Pace {
  Periodic,     ///< both tasks run once a period, as in the paper
  EventDriven,  ///< both tasks sleep until something arrives; SCS uses fresh() and a blocking write
};
enum class Transport { Unix, Tcp, Tls };  ///< only suture-bench network measures Tls

/// This is what lies between the two processes of a loop.
struct Between {
  suture::Lane lane = suture::Lane::Rpc;
  Transport transport = Transport::Unix;
  bool namespaces = false;  ///< each process has one of the network, and a cable joins them
};

struct LoopSetup {
  Loop loop = Loop::Scs;
  Pace pace = Pace::Periodic;
  suture::Duration period = std::chrono::milliseconds(1);
  suture::rt::Scheduling scheduling{};  ///< of both tasks; the other threads share its processor
  std::size_t skip = 1000;              ///< rounds before those that are measured
  std::size_t samples = 10000;

  std::size_t total() const { return skip + samples; }
};

}  // namespace bench
