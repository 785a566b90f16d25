#include <signal.h>
#include <suture/component/channel/channel.h>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <thread>

#include "bench/figures/table.h"
#include "bench/local/sample_device.h"
#include "bench/network/lanes.h"
#include "bench/network/processes/sample_process.h"
#include "bench/network/rows.h"

namespace bench {
namespace {

using suture::now;
using suture::SetupError;
using suture::Time;
using namespace std::chrono_literals;

constexpr suture::Duration kSilenceBound = 200ms;

/// This is a client that is connected to the provider in another process.
struct Connected {
  Connected(const suture::Lane& lane, const NetworkOptions& options,
            const suture::ConnectionContract& contract = {})
      : server(Transport::Unix, options.otherCpu) {
    server.manager().add("Client", client);
    server.manager().start();
    connectBy(lane, server.manager(), "Client/Server", "server:Server/Samples", contract);
    channel = server.manager().channels().at(0);
  }

  /// Returns the time from the signal until the client's connection is known to be lost, ns.
  std::int64_t untilLost(int signal) {
    return after(signal, "a lost connection",
                 [this] { return channel->status != suture::ChannelStatus::Connected; });
  }
  /// Returns the time from the signal until the client is connected anew, ns.
  std::int64_t untilBack(int signal) {
    return after(signal, "a new connection", [this] { return client.server.connected(); });
  }

  template <class Condition>
  std::int64_t after(int signal, const char* wanted, const Condition& holds) {
    const Time begin = now();
    kill(server.pid(), signal);
    while (!holds()) {
      if (now() - begin > 10s) throw SetupError(wanted, "none in 10 s", "Run it again");
      std::this_thread::sleep_for(50us);
    }
    return (now() - begin).count();
  }

  SampleDevice client;  // outlives its manager
  SampleProcess server;
  std::shared_ptr<suture::Channel> channel;
};

/// Times a new process's part: a manager, its names, the handshake and the lane; to a server that
/// is there.
std::int64_t connectFromCold(const suture::Lane& lane, const Names& names) {
  SampleDevice client;
  const Time begin = now();
  suture::Manager manager("cold", names.address());
  manager.add("Client", client);
  manager.start();
  connectBy(lane, manager, "Client/Server", "server:Server/Samples");
  return (now() - begin).count();
}

std::int64_t killOne(const suture::Lane& lane, const NetworkOptions& options) {
  Connected connected(lane, options);
  std::this_thread::sleep_for(20ms);  // idle
  const std::int64_t elapsed = connected.untilLost(SIGKILL);
  connected.server.abandon();
  return elapsed;
}

std::int64_t stopOne(const suture::Lane& lane, const NetworkOptions& options) {
  Connected connected(lane, options, {.silence = kSilenceBound});
  std::this_thread::sleep_for(kSilenceBound);
  const std::int64_t elapsed = connected.untilLost(SIGSTOP);
  connected.server.abandon();
  return elapsed;
}

/// Returns the time from the end of a silence that lost the connection.
std::int64_t resumeOne(const suture::Lane& lane, const NetworkOptions& options) {
  Connected connected(lane, options, {.silence = kSilenceBound});
  connected.untilLost(SIGSTOP);
  return connected.untilBack(SIGCONT);
}

/// Returns how many threads there are beyond its task and the one that main() runs in.
double threadsBeyondTasks(const suture::Lane& lane, const NetworkOptions& options) {
  const Connected connected(lane, options);
  const std::filesystem::directory_iterator threads(
      "/proc/" + std::to_string(connected.server.pid()) + "/task");
  return static_cast<double>(std::distance(begin(threads), end(threads))) - 2;
}

Statistics repeated(std::size_t times, const std::function<std::int64_t()>& measure) {
  std::vector<std::int64_t> elapsed;
  for (std::size_t i = 0; i < times; ++i) elapsed.push_back(measure());
  return statisticsOf(inUnits(elapsed, kMillisecond));
}

}  // namespace

std::string linkTimeRows(const NetworkOptions& options, Report& report) {
  Table table(2);
  table.row(joined({"ms", "lane"}, statisticsTitles()));
  table.line();
  for (const suture::Lane& lane : kLanes) {
    const std::string name = toString(lane);
    const auto row = [&](const char* title, const std::string& figure, const Statistics& times) {
      report.add(figure + "." + name, "ms", times);
      table.row(joined({title, name}, cellsOf(times, 2)));
    };
    row("connected from cold", "connect", repeated(options.links(), [&] {
          const SampleProcess server(Transport::Unix, options.otherCpu);
          connectFromCold(lane, server.names());  // waits until the server is there
          return connectFromCold(lane, server.names());
        }));
    row("SIGKILL noticed", "killed",
        repeated(options.links(), [&] { return killOne(lane, options); }));
    const Statistics silence = repeated(options.links(), [&] { return stopOne(lane, options); });
    row("silence noticed, bound 200 ms", "silence", silence);
    report.add("silence." + name + ".ratio", "x",
               silence.p50 * kMillisecond / static_cast<double>(kSilenceBound.count()));
    row("connected anew after silence", "reconnect",
        repeated(options.links(), [&] { return resumeOne(lane, options); }));
    const double threads = threadsBeyondTasks(lane, options);
    report.add("threads." + name, "threads", threads);
    table.row({"threads of a server beyond its task", name, number(threads, 0)});
  }
  return table.toString();
}

}  // namespace bench
