#include "verdict.h"

#include <fmt/format.h>
#include <suture/base/errors.h>
#include <suture/observe/merge.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numbers>

#include "recorder/recording.h"
#include "run/stop.h"
#include "tables/losses.h"
#include "tables/units.h"
#include "timing/seconds.h"

namespace demo {
namespace {

using suture::ConnectionReport;

constexpr double kDegreesOfRadian = 180 / std::numbers::pi;
// After a stop an arm may move this much longer than drives live without a permit: what stops has
// to brake, and its recorder to look.
constexpr suture::Duration kStopping = std::chrono::milliseconds(50);

suture::TaskReport taskOf(const std::vector<suture::Report>& reports, const std::string& name) {
  for (const suture::Report& report : reports) {
    for (const suture::TaskReport& task : report.tasks) {
      if (report.process + ":" + task.name == name) return task;
    }
  }
  return {};
}

/// A process that misses a connection at its end says so by its exit status, so what was lost has
/// come back.
std::string whatWasLost(const CrewResult& result,
                        const std::vector<ConnectionReport>& connections) {
  const auto lost = std::count_if(connections.begin(), connections.end(),
                                  [](const ConnectionReport& one) { return lossesOf(one) > 0; });
  if (result.outage) return "had every connection again";
  if (lost == 0) return "lost nothing";
  return fmt::format("have again the {} that they lost",
                     counted(static_cast<std::size_t>(lost), "connection"));
}

Check checkProcesses(const CrewResult& result, const std::vector<ConnectionReport>& connections) {
  if (!result.failures.empty()) return {false, result.failures.front()};
  return {true, fmt::format("{} ran to the end and {}", counted(result.reports.size(), "process"),
                            whatWasLost(result, connections))};
}

/// Returns what is wrong with the lane of a connection; "" if it had the one that it was given.
std::string laneProblem(const std::string& name, const std::string& lane,
                        const std::vector<ConnectionReport>& connections) {
  const auto found = std::find_if(connections.begin(), connections.end(),
                                  [&](const ConnectionReport& one) { return one.name == name; });
  if (found == connections.end()) return name + " was not made";
  if (found->lane != lane) {
    return fmt::format("{} was to use lane '{}' and used '{}'", name, lane, found->lane);
  }
  if (lane != "local" && found->bytesSent + found->bytesReceived == 0) {
    return fmt::format("{}: nothing crossed its lane '{}'", name, lane);
  }
  return "";
}

/// Checks that one program ran all processes, because the topology must not be in the program.
Check checkPrograms(const std::vector<ProgramHash>& programs) {
  std::vector<std::string> texts;
  for (const ProgramHash& one : programs) {
    texts.push_back(fmt::format("{}, SHA-256 {}", one.name, one.sha256));
  }
  if (texts.empty()) return {false, "no process has run its program"};
  return {texts.size() == 1, fmt::format("{}{}",
                                         texts.size() == 1 ? "every process ran "
                                                           : "processes ran different programs: ",
                                         fmt::join(texts, " and "))};
}

Check checkLanes(const Plan& plan, const std::vector<ConnectionReport>& connections) {
  for (const auto& [name, lane] : plan.lanes()) {
    if (const auto problem = laneProblem(name, lane, connections); !problem.empty()) {
      return {false, problem};
    }
  }
  return {true, counted(plan.lanes().size(), "connection") + " used the lane they were given"};
}

/// Adds to what is wrong that records are missing, which may have told more.
std::vector<std::string> withLost(std::vector<std::string> violations, std::uint64_t lost) {
  if (lost == 0) return violations;
  violations.push_back(counted(lost, "record") + " did not get into a file of the recorders");
  return violations;
}

/// Returns when that slave need not follow, because of what the options of this run do to it.
std::vector<robots::Span> excusesOf(const FollowingWatch& watch, const Plan& plan,
                                    const std::optional<Break>& cutOff, const CrewResult& result) {
  std::vector<robots::Span> excuses;
  const auto isIt = [&](const RecordedSlave& one) { return one.name == watch.following().slave; };
  if (result.cutOff && std::any_of(cutOff->slaves.begin(), cutOff->slaves.end(), isIt)) {
    excuses.push_back({*result.cutOff, result.outage ? result.outage->mended : result.ended});
  }
  const auto stop = plan.stop() ? firstStop(watch.slave().stops()) : std::nullopt;
  if (stop) excuses.push_back({stop->pressed, stop->released.value_or(result.ended)});
  return excuses;
}

ArmFigures& figuresOf(const std::string& name, std::vector<ArmFigures>& arms) {
  return *std::find_if(arms.begin(), arms.end(),
                       [&](const ArmFigures& arm) { return arm.name == name; });
}

/// Judges one slave from the recordings; fills its figures.
Check checkFollowing(const Plan& plan, const std::optional<Break>& cutOff, const CrewResult& result,
                     FollowingWatch& watch, ArmFigures& slave) {
  const Following& following = watch.following();
  slave.master = following.master;
  const std::string pair = following.slave + " follows " + following.master;
  try {
    watch.readRest();
  } catch (const suture::SetupError& error) {
    return {false, pair + ": " + error.what()};
  }
  slave.following = watch.finish(result.ended, excusesOf(watch, plan, cutOff, result));
  const robots::Judgement& judgement = *slave.following;
  const auto violations = withLost(robots::violations(judgement), watch.lost());
  if (!violations.empty()) return {false, fmt::format("{}: {}", pair, fmt::join(violations, "; "))};
  return {
      true,
      fmt::format("{} within {:.2f} mm and {:.2f} deg at p99, over {:.0f} mm, for {:.0f} % of "
                  "the time",
                  pair, 1e3 * judgement.position.p99, kDegreesOfRadian * judgement.orientation.p99,
                  1e3 * judgement.travel, 1e2 * judgement.followed.share)};
}

/// Reads the rest of what a slave that follows no master alone has recorded.
std::optional<Check> readRest(SlaveWatch& watch) {
  try {
    watch.rest();
  } catch (const suture::SetupError& error) {
    return Check{false, watch.slave().name + ": " + error.what()};
  }
  const auto lost = withLost({}, watch.lost());
  if (lost.empty()) return std::nullopt;
  return Check{false, watch.slave().name + ": " + lost.front()};
}

/// Judges that no slave jumped during the whole run; fills their figures.
Check checkJumps(const std::vector<const SlaveWatch*>& slaves, std::vector<ArmFigures>& arms) {
  std::vector<std::string> found;
  double astray = 0;
  for (const SlaveWatch* watch : slaves) {
    const robots::JumpJudgement jumps = watch->jumps();
    figuresOf(watch->slave().name, arms).jumps = jumps;
    astray = std::max(astray, jumps.astray);
    for (const std::string& violation : robots::violations(jumps)) {
      found.push_back(fmt::format("{}: {}", watch->slave().name, violation));
    }
  }
  if (!found.empty()) return {false, fmt::format("{}", fmt::join(found, "; "))};
  return {true, fmt::format("{} never jumped, and stayed within {:.2f} mm of the path of their "
                            "set-points",
                            counted(slaves.size(), "slave"), 1e3 * astray)};
}

/// Returns how well the fixtures kept knot and tips, as the end of a sentence; "" if they were off.
std::string withinFixtures(const robots::KnotJudgement& judgement) {
  if (!judgement.outside) return "";
  return fmt::format(", and it left its corridor by {:.2f} mm at most",
                     1e3 * std::max(*judgement.outside, 0.0));
}

/// Judges the placing of the knot from its recording; fills its figures.
Check checkKnot(const KnotPlacing& placing, std::optional<robots::KnotJudgement>& figures) {
  std::uint64_t lost = 0;
  try {
    const robots::KnotRecording recording = robots::readKnotRecording(placing.recording);
    figures = robots::judgeKnot(recording.rows, placing.target,
                                placing.isBounded ? std::optional(placing.bounds) : std::nullopt);
    lost = recording.lost;
  } catch (const suture::SetupError& error) {
    return {false, error.what()};
  }
  const auto violations = withLost(robots::violations(*figures), lost);
  if (!violations.empty()) return {false, fmt::format("{}", fmt::join(violations, "; "))};
  return {true, fmt::format("the knot came from {:.1f} to {:.2f} mm from its target; while it was "
                            "guided, the cameras saw it {:.0f} % of the time, within {:.2f} mm at "
                            "p99{}",
                            1e3 * figures->start, 1e3 * figures->error, 1e2 * figures->sighted,
                            1e3 * figures->sighting_error, withinFixtures(*figures))};
}

/// These words say what happened: "with vision cut off", and when it was over: "that was mended".
struct Happening {
  std::string during, over;
};

/// Judges if a slave held during that span; fills its figures.
Check judgeHeld(const std::string& slave, const robots::Recording& recording,
                const robots::Span& span, const Happening& happening,
                const robots::HoldBounds& bounds, std::vector<HeldSlave>& held) {
  const std::string subject = fmt::format("{}, {}", slave, happening.during);
  const robots::HoldJudgement judgement = robots::judgeHold(recording.arm, span.begin, span.end);
  held.push_back({slave, judgement});
  const auto violations = withLost(robots::violations(judgement, bounds), recording.lost);
  if (!violations.empty())
    return {false, fmt::format("{}: {}", subject, fmt::join(violations, "; "))};
  return {true,
          fmt::format("{} for {:.0f} ms, held after {:.0f} ms, moved again {:.0f} ms after "
                      "{}, and did not jump",
                      subject, 1e3 * robots::secondsBetween(span.begin, span.end),
                      1e3 * judgement.held_after, 1e3 * *judgement.resumed_after, happening.over)};
}

Check checkHeld(const RecordedSlave& slave, const std::string& process, const Outage& outage,
                std::vector<HeldSlave>& held) {
  try {
    return judgeHeld(slave.name, robots::readRecording(slave.recording),
                     {outage.broken, outage.mended},
                     {fmt::format("with {} cut off", process), "that was mended"}, {}, held);
  } catch (const suture::SetupError& error) {
    return {false, slave.name + ": " + error.what()};
  }
}

Check checkStopped(const RecordedSlave& slave, suture::Duration permit,
                   std::vector<HeldSlave>& held) {
  try {
    const robots::Recording recording = robots::readRecording(slave.recording);
    const auto stop = firstStop(recording.stops);
    if (!stop || !stop->released) {
      return {false, slave.name + " heard of no stop, or not of its release"};
    }
    return judgeHeld(slave.name, recording, {stop->pressed, *stop->released},
                     {"with the stop pressed", "its release"},
                     {.held_after = robots::inSeconds(permit + kStopping)}, held);
  } catch (const suture::SetupError& error) {
    return {false, slave.name + ": " + error.what()};
  }
}

/// A recorder may hear so much later than the teleoperation that the clutch was released, so that
/// the slave moves again before.
constexpr suture::Duration kLateNews = std::chrono::milliseconds(500);
/// A shorter press may be no more than a moment without news of the pedals.
constexpr suture::Duration kShortestPress = 2 * kLateNews;
constexpr suture::Duration kFollowsAgain = std::chrono::seconds(3);

/// Judges that a slave held while the clutch was pressed, and went on from there.
Check checkClutched(const std::string& slave, const std::filesystem::path& recorded,
                    const robots::Span& pressed, std::vector<HeldSlave>& held) {
  const std::string subject = slave + ", with the clutch pressed";
  try {
    const robots::Recording recording = robots::readRecording(recorded);
    const robots::HoldJudgement judgement =
        robots::judgeHold(recording.arm, pressed.begin, pressed.end - kLateNews);
    held.push_back({slave, judgement});
    const auto violations = withLost(robots::violations(judgement), recording.lost);
    if (!violations.empty()) {
      return {false, fmt::format("{}: {}", subject, fmt::join(violations, "; "))};
    }
  } catch (const suture::SetupError& error) {
    return {false, subject + ": " + error.what()};
  }
  return {true, fmt::format("{} for {:.0f} ms, held, and went on from there without a jump",
                            subject, 1e3 * robots::secondsBetween(pressed.begin, pressed.end))};
}

/// Judges each slave while the clutch was pressed, if it had time to follow again.
void checkClutches(const FollowingWatch& watch, suture::Time end, Verdict& verdict) {
  const std::string& slave = watch.following().slave;
  const auto presses = watch.clutched(end);
  bool isJudged = presses.empty();
  for (const robots::Span& pressed : presses) {
    if (pressed.end - pressed.begin < kShortestPress || pressed.end + kFollowsAgain > end) continue;
    isJudged = true;
    verdict.checks.push_back(
        checkClutched(slave, watch.following().slaveRecording, pressed, verdict.held));
  }
  if (isJudged) return;
  verdict.checks.push_back({true, slave + ", with the clutch pressed: not judged, because that was "
                                          "for less than 1 s or less than 3 s before the end"});
}

}  // namespace

bool Verdict::passed() const {
  return std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.passed; });
}

Verdict judgeRun(const Plan& plan, const std::optional<Break>& cutOff, const CrewResult& result,
                 Watches& watches) {
  Verdict verdict;
  verdict.connections = suture::mergeConnections(result.reports);
  for (const std::string& arm : plan.arms()) {
    verdict.arms.push_back({arm, taskOf(result.reports, arm), "", {}, {}});
  }
  verdict.checks = {checkProcesses(result, verdict.connections), checkPrograms(result.programs),
                    checkLanes(plan, verdict.connections)};
  std::vector<const SlaveWatch*> slaves;
  for (FollowingWatch& watch : watches.followings) {
    ArmFigures& slave = figuresOf(watch.following().slave, verdict.arms);
    verdict.checks.push_back(checkFollowing(plan, cutOff, result, watch, slave));
    slaves.push_back(&watch.slave());
  }
  for (SlaveWatch& watch : watches.others) {
    if (const auto problem = readRest(watch)) verdict.checks.push_back(*problem);
    slaves.push_back(&watch);
  }
  if (!slaves.empty()) verdict.checks.push_back(checkJumps(slaves, verdict.arms));
  if (plan.knot()) verdict.checks.push_back(checkKnot(*plan.knot(), verdict.knot));
  for (const FollowingWatch& watch : watches.followings) {
    checkClutches(watch, result.ended, verdict);
  }
  if (plan.stop() && !result.interrupted) {
    for (const RecordedSlave& slave : plan.slaves()) {
      verdict.checks.push_back(checkStopped(slave, plan.permit(), verdict.held));
    }
  }
  if (!result.outage) return verdict;
  if (cutOff->slaves.empty()) {
    verdict.checks.push_back(
        {true, fmt::format("no slave depends directly on {}, so that none had to hold",
                           cutOff->process)});
  }
  for (const RecordedSlave& slave : cutOff->slaves) {
    verdict.checks.push_back(checkHeld(slave, cutOff->process, *result.outage, verdict.held));
  }
  return verdict;
}

}  // namespace demo
