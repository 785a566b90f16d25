#include <linux/tcp.h>
#include <netinet/in.h>
#include <suture/component/channel/channel.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <thread>

#include "bench/figures/table.h"
#include "bench/network/lanes.h"
#include "bench/network/names.h"
#include "bench/network/process_usage.h"
#include "bench/network/processes/subscriber_process.h"
#include "bench/network/processor_time.h"
#include "bench/network/rows.h"
#include "bench/network/sleeper.h"
#include "bench/table2/processes/child_process.h"

namespace bench {
namespace {

using suture::SetupError;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

/// Says what a pair of processes has used, or holds.
struct Usage {
  double processor = 0;  ///< s
  double wakeUps = 0;
  double bytes = 0;  ///< over TCP, as this process has them
  double descriptors = 0;
  double resident = 0;  ///< KiB of the client
};

double residentOf(pid_t pid) {
  double size = 0, resident = 0;
  std::ifstream("/proc/" + std::to_string(pid) + "/statm") >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1024;
}

double tcpBytes() {
  double sum = 0;
  for (const auto& one : fs::directory_iterator("/proc/self/fd")) {
    tcp_info info{};
    socklen_t size = sizeof(info);
    const int socket = std::stoi(one.path().filename());
    if (getsockopt(socket, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) continue;
    sum += static_cast<double>(info.tcpi_bytes_acked + info.tcpi_bytes_received);
  }
  return sum;
}

Usage usageOf(pid_t client) {
  return {.processor = processorTime(getpid()) + processorTime(client),
          .wakeUps = wakeUpsOf(getpid()) + wakeUpsOf(client),
          .bytes = tcpBytes(),
          .descriptors = descriptorsOf(getpid()) + descriptorsOf(client),
          .resident = residentOf(client)};
}

/// Says what a second of idle connections costs, and what has been used to make them.
struct Idle {
  Usage each;  ///< s
  Usage held;
  double further;  ///< ms to make each connection but the first; 0: there is none
};

std::size_t standing(const suture::Manager& manager) { return manager.channels().size(); }

void await(const suture::Manager& manager, std::size_t wanted) {
  const suture::Time deadline = suture::now() + 1min;
  while (standing(manager) < wanted) {
    if (suture::now() > deadline) {
      throw SetupError(std::to_string(wanted) + " connections",
                       std::to_string(standing(manager)) + " after a minute", "Run it again");
    }
    std::this_thread::sleep_for(1ms);
  }
}

Idle idle(const suture::Lane& lane, std::size_t connections, const NetworkOptions& options) {
  const Names names(lane == suture::Lane::Shm ? Transport::Unix : Transport::Tcp);
  Sleeper sleeper;
  suture::Manager manager("sender", names.address());
  manager.add("Sender", sleeper);
  manager.start();
  ChildProcess client(subscriberProcessArguments({.process = "subscriber",
                                                  .manager = names.address(),
                                                  .lane = lane,
                                                  .interfaces = connections,
                                                  .samples = 1}));
  await(manager, 1);
  const suture::Time first = suture::now();
  await(manager, connections);
  const double making = std::chrono::duration<double, std::milli>(suture::now() - first).count();
  std::this_thread::sleep_for(options.idleWindow() / 4);  // work that making them began has ended

  const Usage before = usageOf(client.pid());
  const suture::Time begin = suture::now();
  std::this_thread::sleep_for(options.idleWindow());
  const Usage after = usageOf(client.pid());
  const double seconds = std::chrono::duration<double>(suture::now() - begin).count();
  client.finish();
  manager.stop();
  const auto perSecond = [seconds](double from, double to) { return (to - from) / seconds; };
  return {.each = {.processor = 100 * perSecond(before.processor, after.processor),
                   .wakeUps = perSecond(before.wakeUps, after.wakeUps),
                   .bytes = perSecond(before.bytes, after.bytes)},
          .held = after,
          .further = connections == 1 ? 0 : making / static_cast<double>(connections - 1)};
}

constexpr std::array<std::size_t, 4> kConnections = {1, 16, 64, 256};

/// Returns what a client keeps for a connection, for as long as it stands, KiB: its queues and
/// rows.
double queuesAndRows() {
  const suture::InterfaceInfo& contract = suture::interfaceInfo<SampleServer>();
  std::vector<std::uint32_t> columns;
  for (const suture::CommandInfo& one : contract.commands) {
    if (one.column >= 0) columns.push_back(one.resultSize);
  }
  const std::size_t bytes =
      suture::Channel::bytesFor(contract) +
      suture::rt::StateTable::bytesFor(columns, suture::rt::StateTable::kDefaultRows);
  return static_cast<double>(bytes) / 1024;
}

void addFigures(const std::string& lane, const Idle& one, const Idle& most, Report& report) {
  const std::string figure = "idle." + lane;
  const double more = static_cast<double>(kConnections.back() - 1);
  report.add(figure + ".load.ratio", "x", most.each.processor / one.each.processor);
  report.add(figure + ".wake_ups.ratio", "x", most.each.wakeUps / one.each.wakeUps);
  if (lane == "shm") {
    report.addUnavailable(figure + ".bytes.ratio", "a Unix socket does not count its bytes");
  } else {
    report.add(figure + ".bytes.ratio", "x", most.each.bytes / one.each.bytes);
  }
  report.add(figure + ".descriptors", "each",
             (most.held.descriptors - one.held.descriptors) / more);
  const double memory = (most.held.resident - one.held.resident) / more;
  report.add(figure + ".memory", "KiB", memory - queuesAndRows());
  report.add(figure + ".further", "ms", most.further);
}

}  // namespace

std::string idleRows(const NetworkOptions& options, Report& report) {
  Table table(2);
  table.row({"idle connections of two processes", "lane", "load %", "wake-ups/s", "bytes/s",
             "descriptors", "client KiB", "ms each"});
  table.line();
  for (const suture::Lane& lane : kLanes) {
    std::vector<Idle> all;
    for (const std::size_t connections : kConnections) {
      const Idle& now = all.emplace_back(idle(lane, connections, options));
      table.row({std::to_string(connections), toString(lane), number(now.each.processor, 2),
                 number(now.each.wakeUps, 1), number(now.each.bytes, 0),
                 number(now.held.descriptors, 0), number(now.held.resident, 0),
                 number(now.further, 2)});
    }
    addFigures(toString(lane), all.front(), all.back(), report);
  }
  return table.toString();
}

}  // namespace bench
