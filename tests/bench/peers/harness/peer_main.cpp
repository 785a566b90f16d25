#include "harness/peer_main.h"

#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cstdio>
#include <map>

#include "harness/fail.h"
#include "harness/measurements/measurements.h"

namespace peers {
namespace {

using Measurement = void (*)(Peer&, const Options&, ControlBlock&);

/// Ends the process with the one that started it, and after two minutes, so that nothing outlives a
/// run.
void boundThisProcess() {
  constexpr unsigned kLongestRun = 120;  // s
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  alarm(kLongestRun);
}

/// Sleeps end when they should: the kernel otherwise adds 50 us.
void setTimerSlack() { prctl(PR_SET_TIMERSLACK, 1000); }

void pin(int cpu) {
  if (cpu < 0) return;
  cpu_set_t cpus;
  CPU_ZERO(&cpus);
  CPU_SET(cpu, &cpus);
  if (sched_setaffinity(0, sizeof cpus, &cpus) != 0) fail("there is no CPU of that number");
}

void serve(Peer& peer, const Options& options, ControlBlock& control) {
  control.process[options.server] = getpid();
  peer.serve(options, Sink(control, options.server), [&] { control.ready[options.server] = 1; });
}

void measure(Peer& peer, const Options& options, ControlBlock& control) {
  static const std::map<std::string, Measurement> measurements{
      {"round_trip", measureRoundTrips},
      {"stream", measureStream},
      {"payload", measurePayloads},
      {"fan_out", measureFanOut},
  };
  const auto found = measurements.find(options.measurement);
  if (found == measurements.end()) fail("there is no measurement " + options.measurement);
  control.awaitReady(options.servers);
  peer.inClientThread(options, [&] { found->second(peer, options, control); });
  control.tellToStop();
}

}  // namespace

int peerMain(int count, char** arguments, const PeerOf& peerOf) {
  const Options options = parsedOptions(count, arguments);
  boundThisProcess();
  setTimerSlack();
  pin(options.cpu);
  const std::unique_ptr<Peer> peer = peerOf(options.variant);
  if (peer == nullptr) fail("there is no variant " + options.variant);
  if (options.measurement == "conversion") {
    measureConversion(*peer, options);
    return 0;
  }
  ControlBlock& control = ControlBlock::open(options.control);
  if (options.role == "server") {
    serve(*peer, options, control);
  } else {
    measure(*peer, options, control);
  }
  return 0;
}

}  // namespace peers
