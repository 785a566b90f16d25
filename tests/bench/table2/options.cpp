#include "bench/table2/options.h"

#include "bench/placement.h"

namespace bench {

Table2Options::Table2Options() : cpu(preferredCpu()) {}

void Table2Options::addTo(CLI::App& options) {
  options.add_option("--samples", samples, "samples kept of each loop")
      ->capture_default_str()
      ->check(CLI::Range(1, 10'000'000));
  options.add_option("--skip", skip, "samples skipped before")->capture_default_str();
  options.add_option("--rate", rateHz, "of the periodic tasks, Hz")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 10000.0));
  options.add_option("--cpu", cpu, "processor for the event-driven loops and the raw sockets")
      ->capture_default_str();
  options.add_option("--fifo-priority", fifoPriority, "of the tasks in the SCHED_FIFO row")
      ->capture_default_str()
      ->check(CLI::Range(1, 99));
  options.add_option("--lane", lane, "that carries the connection between the two processes")
      ->capture_default_str()
      ->check(CLI::IsMember({"rpc", "frame", "shm"}));
  CLI::Option* const overTcp =
      options.add_flag("--tcp", tcp, "TCP over the loopback instead of a Unix socket");
  options
      .add_flag("--namespaces", namespaces,
                "TCP through a cable between two network namespaces, which needs root")
      ->excludes(overTcp);
  options.add_flag("--quick", quick, "100 samples a loop: shows that it works, not how well");
  options.add_flag("--event-driven-only", eventDrivenOnly, "without the loops of periodic tasks");
}

nlohmann::json Table2Options::toJson() const {
  return {{"samples", kept()},
          {"skip", skipped()},
          {"rate", rateHz},
          {"cpu", cpu},
          {"fifo_priority", fifoPriority},
          {"lane", lane},
          {"transport", namespaces ? "namespaces"
                        : tcp      ? "tcp"
                                   : "unix"},
          {"quick", quick},
          {"event_driven_only", eventDrivenOnly}};
}

Between Table2Options::between() const {
  return {.lane = {lane},
          .transport = tcp || namespaces ? Transport::Tcp : Transport::Unix,
          .namespaces = namespaces};
}

std::string Table2Options::betweenInWords() const {
  if (lane == "shm") return "shm, agreed on over a Unix socket";
  if (namespaces) return lane + " over TCP through a cable between two network namespaces";
  return lane + (tcp ? " over TCP" : " over a Unix socket");
}

LoopSetup Table2Options::periodic(Loop loop, bool fifo) const {
  LoopSetup setup{.loop = loop, .pace = Pace::Periodic, .skip = skipped(), .samples = kept()};
  setup.period = suture::Duration(static_cast<std::int64_t>(1e9 / rateHz));
  if (fifo) {
    setup.scheduling.policy = suture::rt::Policy::Fifo;
    setup.scheduling.priority = fifoPriority;
  }
  return setup;
}

LoopSetup Table2Options::eventDriven(Loop loop) const {
  LoopSetup setup{.loop = loop, .pace = Pace::EventDriven, .skip = skipped(), .samples = kept()};
  setup.scheduling.processor = cpu;
  return setup;
}

}  // namespace bench
