#include "run/processes.h"

#include <poll.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <limits>
#include <nlohmann/json.hpp>

namespace demo {
namespace {

using namespace std::chrono_literals;
using suture::Duration;
using suture::Time;

constexpr Duration kStartPatience = 30s;
constexpr Duration kEndPatience = 5s;
// After a process has died, this is how long the others may take to report what they lost.
constexpr Duration kAftermath = 1500ms;
// The report of the last full second is on its way when that second is over.
constexpr Duration kLastReport = 500ms;
// After a break, this is how long it may take until the last loss is noticed, because silence has
// to pass first.
constexpr Duration kRecovery = 3s;
constexpr int kReportDescriptor = 3;

sigset_t endSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) sigaddset(&signals, number);
  return signals;
}

int watchEndSignals() {
  const sigset_t signals = endSignals();
  return signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
}

}  // namespace

void blockEndSignals() {
  const sigset_t signals = endSignals();
  sigprocmask(SIG_BLOCK, &signals, nullptr);
}

Crew::Crew(Plan& plan, Network& network, std::optional<Break> cutOff,
           std::filesystem::path programs, std::filesystem::path folder)
    : plan_(plan),
      network_(network),
      cutOff_(std::move(cutOff)),
      programs_(std::move(programs)),
      folder_(std::move(folder)),
      signals_(watchEndSignals()) {}

Crew::~Crew() { close(signals_); }

CrewResult Crew::run(Duration length, const Progress& progress) {
  if (plan_.needsManager()) startManager();
  if (!over()) startWorkstations();
  if (!over()) awaitStarted();
  if (!over()) watch(length, progress);
  end();
  result_.reports = reports();
  return std::move(result_);
}

void Crew::startManager() {
  std::vector<std::string> arguments{programs_ / "suture-manager", "--listen",
                                     plan_.deployment().manager()};
  if (network_.needsKeys()) {
    arguments.insert(arguments.end(), {"--keys", plan_.deployment().keys()});
  }
  manager_ = std::make_unique<ChildProcess>(ChildProcess::Start{.title = "the global manager",
                                                                .arguments = std::move(arguments),
                                                                .directory = folder_,
                                                                .reportsTo = STDOUT_FILENO,
                                                                .connect = {}});
  pumpUntil(suture::now() + kStartPatience, [this] { return over() || managerReady_; });
}

void Crew::startWorkstations() {
  std::function<void(pid_t)> connect;
  for (const suture::ProcessEntry& process : plan_.deployment().processes()) {
    if (network_.hasNamespaces()) {
      connect = [&](pid_t child) { network_.connect(process.name, child); };
    }
    workstations_.push_back(std::unique_ptr<Workstation>(new Workstation{
        .process = ChildProcess({.title = "process '" + process.name + "'",
                                 .arguments = {programs_ / "suture-workstation", "--deployment",
                                               plan_.file(), "--process", process.name,
                                               "--report-fd", std::to_string(kReportDescriptor)},
                                 .directory = folder_,
                                 .reportsTo = kReportDescriptor,
                                 .connect = connect}),
        .report = {
            .process = process.name, .age = {}, .connections = {}, .tasks = {}, .devices = {}}}));
  }
}

bool Crew::allStarted() const {
  return std::all_of(workstations_.begin(), workstations_.end(),
                     [](const auto& one) { return one->started; });
}

void Crew::awaitStarted() {
  pumpUntil(suture::now() + kStartPatience, [this] { return over() || allStarted(); });
  for (const auto& one : workstations_) {
    if (over() || one->started) continue;
    result_.failures.push_back(one->process.title() + " has not made its connections within 30 s");
  }
}

std::uint64_t Crew::reportsOfEach() const {
  std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
  for (const auto& one : workstations_) fewest = std::min(fewest, one->reports);
  return fewest;
}

void Crew::watch(Duration length, const Progress& progress) {
  const Time began = suture::now();
  std::uint64_t shown = reportsOfEach();
  progress(Duration{0}, reports());
  const auto showNewReports = [&](Time until) {
    pumpUntil(until, [&] { return over() || reportsOfEach() > shown; });
    if (reportsOfEach() == shown) return;
    shown = reportsOfEach();
    progress(suture::now() - began, reports());
  };
  while (!over() && suture::now() < endOfRun(began, length)) {
    showNewReports(std::min(breakOrMend(began), endOfRun(began, length)));
  }
  result_.ran = suture::now() - began;
  showNewReports(suture::now() + kLastReport);
}

/// Returns the end of the run, which goes on behind a break for as long as was asked, even if a
/// busy machine made the break late.
Time Crew::endOfRun(Time began, Duration length) const {
  if (!cutOff_) return began + length;
  const auto [at, brokenFor] = cutOff_->moment;
  const Duration after = length - at - brokenFor;
  return result_.outage ? result_.outage->mended + after : Time::max();
}

/// Does what is due, and returns when there is more to do.
Time Crew::breakOrMend(Time began) {
  if (!cutOff_ || result_.outage) return Time::max();
  if (suture::now() < began + cutOff_->moment.at) return began + cutOff_->moment.at;
  if (!broken_) cut();
  if (suture::now() < *broken_ + cutOff_->moment.length) return *broken_ + cutOff_->moment.length;
  // A process that goes on may move its arms before this one runs again, so the moment is taken
  // first.
  result_.outage = {*broken_, suture::now()};
  mend();
  return Time::max();
}

/// Pulls the process's cable, or freezes the process if it has none. The kernel may delay a change
/// of a cable for seconds while it takes down other namespaces, so the moment is taken when it is
/// done.
void Crew::cut() {
  result_.cutOff = suture::now();
  if (network_.hasNamespaces()) {
    network_.setCable(cutOff_->process, false);
  } else {
    workstation(cutOff_->process).signal(SIGSTOP);
  }
  broken_ = suture::now();
}

void Crew::mend() {
  broken_.reset();
  if (network_.hasNamespaces()) return network_.setCable(cutOff_->process, true);
  workstation(cutOff_->process).signal(SIGCONT);
}

const ChildProcess& Crew::workstation(const std::string& process) const {
  const auto found = std::find_if(workstations_.begin(), workstations_.end(),
                                  [&](const auto& one) { return one->report.process == process; });
  return (*found)->process;
}

/// A process that gets no time may take long to have its connections again, and says meanwhile that
/// it cannot. If it never has them, its exit status tells.
bool Crew::expectsLosses() const {
  if (broken_) return true;
  if (!result_.outage) return false;
  return suture::now() < result_.outage->mended + kRecovery || missesConnections();
}

/// Tells what the last reports say.
bool Crew::missesConnections() const {
  return std::any_of(workstations_.begin(), workstations_.end(), [](const auto& one) {
    const auto& connections = one->report.connections;
    return std::any_of(connections.begin(), connections.end(), [](const auto& connection) {
      return connection.status == suture::ChannelStatus::Lost;
    });
  });
}

void Crew::end() {
  result_.ended = suture::now();
  if (broken_) mend();  // a frozen process would not handle the signal to end
  if (!result_.interrupted && !result_.failures.empty()) {
    pumpUntil(suture::now() + kAftermath, [this] { return result_.interrupted; });
  }
  ending_ = true;
  std::vector<ChildProcess*> workstations;
  for (const auto& one : workstations_) workstations.push_back(&one->process);
  endAll(workstations);
  if (manager_ != nullptr) endAll({manager_.get()});
  readOutputs();
}

void Crew::endAll(const std::vector<ChildProcess*>& processes) {
  const auto allEnded = [&] {
    return std::none_of(processes.begin(), processes.end(),
                        [](auto* one) { return one->running(); });
  };
  for (ChildProcess* process : processes) process->signal(SIGTERM);
  pumpUntil(suture::now() + kEndPatience, allEnded);
  for (ChildProcess* process : processes) {
    if (!process->running()) continue;
    result_.failures.push_back(process->title() + " did not end within 5 s of being asked to");
    process->signal(SIGKILL);
  }
  pumpUntil(suture::now() + kEndPatience, allEnded);
  noticeEnds();
}

template <class Ended>
void Crew::pumpUntil(Time deadline, const Ended& ended) {
  while (!ended() && suture::now() < deadline) pump(deadline);
}

void Crew::pump(Time until) {
  std::vector<pollfd> waited{{.fd = signals_, .events = POLLIN, .revents = 0}};
  for (const ChildProcess* process : processes()) {
    if (process->output() >= 0) {
      waited.push_back({.fd = process->output(), .events = POLLIN, .revents = 0});
    }
  }
  const Duration left = std::max(until - suture::now(), Duration{0});
  const timespec timeout{.tv_sec = left / 1s, .tv_nsec = (left % 1s).count()};
  ppoll(waited.data(), waited.size(), &timeout, nullptr);
  readOutputs();
  readSignals();
}

void Crew::readSignals() {
  signalfd_siginfo info{};
  while (read(signals_, &info, sizeof(info)) == sizeof(info)) {
    if (info.ssi_signo != SIGCHLD) result_.interrupted = true;
  }
  noticeEnds();
}

void Crew::readOutputs() {
  for (const auto& one : workstations_) {
    for (const std::string& line : one->process.readLines()) handle(*one, line);
  }
  if (manager_ != nullptr) readManager();
}

/// Reads where the manager listens, with which its first line ends.
void Crew::readManager() {
  const auto lines = manager_->readLines();
  if (lines.empty() || managerReady_) return;
  plan_.setManager(lines.front().substr(lines.front().rfind(' ') + 1));
  managerReady_ = true;
}

/// Asks the kernel which program the process really runs; equal files are read once.
void Crew::noticeProgram(const ChildProcess& process) {
  const std::string file = "/proc/" + std::to_string(process.pid()) + "/exe";
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return;  // it has ended, which is reported elsewhere
  if (!hashed_.insert({status.st_dev, status.st_ino}).second) return;
  ProgramHash hash;
  try {
    hash = hashProgram(file);
  } catch (const std::exception& error) {  // it may end at any moment
    result_.failures.push_back(process.title() + ": " + error.what());
    return;
  }
  auto& programs = result_.programs;
  if (std::find(programs.begin(), programs.end(), hash) == programs.end()) programs.push_back(hash);
}

void Crew::handle(Workstation& workstation, const std::string& line) {
  const auto message = nlohmann::json::parse(line);
  const std::string kind = message.at("kind");
  if (kind == "started") {
    workstation.started = true;
    noticeProgram(workstation.process);
  } else if (kind == "report") {
    workstation.report = suture::reportFromJson(message);
    ++workstation.reports;
  } else if (kind == "failure" && !ending_) {
    if (message.at("loss").get<bool>() && expectsLosses()) return;
    result_.failures.push_back(workstation.process.title() + ": " +
                               message.at("text").get<std::string>());
  }
}

void Crew::noticeEnds() {
  for (ChildProcess* process : processes()) {
    if (process->running() || std::find(ended_.begin(), ended_.end(), process) != ended_.end()) {
      continue;
    }
    ended_.push_back(process);
    // A process that lost a peer also says so by its status; that has been reported.
    if (ending_ && (process->succeeded() || !result_.failures.empty())) continue;
    result_.failures.push_back(process->title() + " " + process->ending());
  }
}

std::vector<ChildProcess*> Crew::processes() {
  std::vector<ChildProcess*> all;
  for (const auto& one : workstations_) all.push_back(&one->process);
  if (manager_ != nullptr) all.push_back(manager_.get());
  return all;
}

std::vector<suture::Report> Crew::reports() const {
  std::vector<suture::Report> all;
  for (const auto& one : workstations_) all.push_back(one->report);
  return all;
}

}  // namespace demo
