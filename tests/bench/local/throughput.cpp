#include <suture/base/errors.h>
#include <suture/wiring/connect.h>

#include <ctime>
#include <functional>
#include <future>
#include <utility>

#include "bench/figures/table.h"
#include "bench/local/rows.h"
#include "bench/local/sample_server.h"

namespace bench {
namespace {

constexpr std::size_t kDepth = 4096;  // queue(4096) of the contract

/// Returns the processor time of all threads of this process, ns.
double processTime() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

double wallTime() { return static_cast<double>(suture::toNanoseconds(suture::now())); }

/// Sends what `body` sends, in one cycle of a task.
class Flooder final : public suture::EventTask {
 public:
  using Body = std::function<std::vector<double>(Flooder&)>;

  Flooder(int cpu, Body body)
      : EventTask({.scheduling = {.processor = cpu}}), body_(std::move(body)) {
    pose_.sequence = 0;
  }
  ~Flooder() override { stop(); }

  void run() override {
    if (!body_) return;
    rates_.set_value(std::exchange(body_, nullptr)(*this));
  }
  std::future<std::vector<double>> rates() { return rates_.get_future(); }

  /// Fills the queue, then sleeps until it has been emptied.
  void fillAndWait() {
    for (std::size_t i = 1; i < kDepth; ++i) send();
    ++pose_.sequence;
    if (!server.put.start(pose_).within()) {
      throw suture::SetupError("an answer to a write", "none", "Run it again");
    }
  }
  /// Sends as fast as there is room; the server learns of every few hundred.
  void push(std::size_t count) {
    for (std::size_t i = 1; i <= count; ++i) {
      send();
      if (i % 256 == 0) ringNow();
    }
    ringNow();
  }
  std::uint64_t sent() const { return pose_.sequence; }

  suture::Required<SampleServer> server{*this, "Server"};

 private:
  void send() {
    ++pose_.sequence;
    while (!server.put(pose_)) ringNow();
  }

  Body body_;
  std::promise<std::vector<double>> rates_;
  robots::PoseSample pose_ = poseSample();
};

Statistics measureWrites(int clientCpu, int serverCpu,
                         const std::function<std::vector<double>(Flooder&, SampleTask&)>& body) {
  SampleTask server(serverCpu);
  Flooder client(clientCpu, [&](Flooder& self) { return body(self, server); });
  suture::connectLocally(client.server, server.provided(), "bench");
  auto rates = client.rates();
  server.start();
  client.start();
  Statistics statistics = statisticsOf(rates.get());
  client.stop();
  if (server.executed() != client.sent() || server.outOfOrder() > 0) {
    throw suture::SetupError("every write executed once and in order",
                             std::to_string(server.executed()) + " of " +
                                 std::to_string(client.sent()) + ", " +
                                 std::to_string(server.outOfOrder()) + " out of order",
                             "This is an error of the runtime: report it");
  }
  return statistics;
}

// Returns millions a second of processor time: on one processor, that is the time that passes if no
// other process wants it.
Statistics onOneProcessor(const LocalOptions& options) {
  constexpr std::size_t kFills = 50;
  return measureWrites(options.cpu, options.cpu, [&](Flooder& client, SampleTask&) {
    client.fillAndWait();
    std::vector<double> rates;
    for (std::size_t block = 0; block < options.count(100); ++block) {
      const double begin = processTime();
      for (std::size_t i = 0; i < kFills; ++i) client.fillAndWait();
      rates.push_back(1e3 * kFills * kDepth / (processTime() - begin));
    }
    return rates;
  });
}

Statistics onTwoProcessors(const LocalOptions& options) {
  constexpr std::size_t kBlock = 200'000;
  return measureWrites(options.cpu, options.otherCpu, [&](Flooder& client, SampleTask& server) {
    client.push(kDepth);
    std::vector<double> rates;
    for (std::size_t block = 0; block < options.count(100); ++block) {
      const double begin = wallTime();
      client.push(kBlock);
      while (server.executed() != client.sent()) {
      }
      rates.push_back(1e3 * kBlock / (wallTime() - begin));
    }
    return rates;
  });
}

}  // namespace

std::string throughputRows(const LocalOptions& options, Report& report) {
  Table table(1);
  table.row(joined({"million writes a second"}, statisticsTitles()));
  table.line();
  const Statistics one = onOneProcessor(options);
  report.add("throughput", "M/s", one);
  table.row(joined({"both ends on one processor"}, cellsOf(one, 1)));
  if (options.twoProcessors()) {
    const Statistics two = onTwoProcessors(options);
    report.add("throughput.two_processors", "M/s", two);
    table.row(joined({"each on its own"}, cellsOf(two, 1)));
  } else {
    report.addUnavailable("throughput.two_processors", "needs two processors");
  }
  return table.toString();
}

}  // namespace bench
