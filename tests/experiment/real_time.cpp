#include "experiment/real_time.h"

#include <cstdio>
#include <future>
#include <memory>
#include <stdexcept>
#include <vector>

#include "experiment/experiment.h"
#include "experiment/forked.h"
#include "experiment/link/forwarder.h"
#include "experiment/record.h"
#include "experiment/room/sides.h"
#include "experiment/room/truth.h"

namespace experiment {
namespace {

using suture::Time;

struct Closes {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closes>;

File makeFile() {
  File file(std::tmpfile());
  if (file == nullptr) throw std::runtime_error("there is no room for a temporary file");
  return file;
}

Record recordIn(std::FILE* file) {
  std::rewind(file);
  return readRecord(file);
}

PacketFate fateOf(const Trial& trial) {
  const suture::ConnectionDelay delay = delayOf(trial.link, {}, trial.seed);
  return {.way = delay.answers,
          .jitter = delay.faults.jitter,
          .loss = trial.link.loss,
          .seed = trial.seed};
}

/// Returns the scheduling of the packets, ahead of those who send them.
suture::rt::Scheduling aheadOf(suture::rt::Scheduling scheduling) {
  if (scheduling.policy != suture::rt::Policy::Default) ++scheduling.priority;
  return scheduling;
}

Pair pairAt(Time then, const Course& master, const Course& slave, const Course& setpoint) {
  const auto at = [then](const Course& course) {
    return Eigen::Isometry3d(Eigen::Translation3d(course.at(then)));  // its turn is not needed
  };
  return {at(master), at(slave), at(setpoint)};
}

/// Returns the same as OperatingRoom::truth(), but of an instant that has passed.
Truth truthAt(Time then, const Trial& trial, const Record& console, const Record& table) {
  const Course& rightLead = trial.inputs == Inputs::Two ? console.right : console.left;
  return {.knot = table.knot.at(then),
          .guided = table.guidedAt(then),
          .left = pairAt(then, console.left, table.left, table.leftSetpoint),
          .right = pairAt(then, rightLead, table.right, table.rightSetpoint)};
}

Result judgeRecords(const Trial& trial, const Record& console, const Record& table) {
  std::vector<Moment> moments;
  if (table.guidance.empty()) return judge(moments);
  Tracking tracking;
  const Time begin = suture::fromNanoseconds(table.guidance.front());
  for (std::size_t i = 0; i < momentsIn(kLength); ++i) {
    moments.push_back(tracking.momentOf(truthAt(begin + i * kMomentPeriod, trial, console, table)));
  }
  return judge(moments);
}

}  // namespace

RealTimeResult runInRealTime(const Trial& trial, const suture::rt::Scheduling& scheduling) {
  const LinkEnd here(kConsoleAddress, kTableAddress), there(kTableAddress, kConsoleAddress);
  const File consoleFile = makeFile(), tableFile = makeFile();
  Forked console("console", [&] {
    suture::rt::schedule("the console", scheduling);
    playConsole(trial, here, consoleFile.get());
  });
  Forked table("table", [&] {
    suture::rt::schedule("the table", scheduling);
    playTable(trial, there, tableFile.get());
  });
  Forwarder forwarder(here, there, fateOf(trial));
  const auto forward = [&] {
    suture::rt::configureThisThread("forwarder", aheadOf(scheduling));
    forwarder.runUntil(table.handle());
    console.end();
    forwarder.runUntil(console.handle());
  };
  std::async(std::launch::async, forward).get();
  console.requireSuccess();
  table.requireSuccess();
  const PacketCounts& to = forwarder.thereCounts();
  const PacketCounts& fro = forwarder.backCounts();
  return {.result = judgeRecords(trial, recordIn(consoleFile.get()), recordIn(tableFile.get())),
          .packets = to.taken + fro.taken,
          .lost = to.lost + fro.lost};
}

}  // namespace experiment
