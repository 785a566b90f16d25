#pragma once
// These are the processes of one run, which are started together, watched, and ended together.

#include <suture/base/time.h>
#include <suture/observe/report.h>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "program_hash.h"
#include "run/break.h"
#include "run/child_process.h"
#include "run/plan.h"

namespace demo {

struct CrewResult {
  std::vector<suture::Report> reports;  ///< the last of each process
  std::vector<std::string> failures;    ///< each names what went wrong
  bool interrupted = false;             ///< Ctrl-C or a request ended it
  std::vector<ProgramHash> programs;    ///< that ran as workstations; each is listed once
  std::optional<Outage> outage;         ///< set if a process was cut off and is back
  suture::Duration ran{};               ///< from when all were connected
  suture::Time ended;                   ///< when every process was asked to end
  std::optional<suture::Time> cutOff;   ///< when a process began to be cut off, if one was
};

/// Blocks the signals that end a run, so that from then on it ends in order, because a Crew watches
/// them. Call it before anything that has to be undone.
void blockEndSignals();

/// One thread, and one run for each object. Holds a global manager, if the plan needs one, and a
/// workstation for each process.
class Crew {
 public:
  /// The run calls this at its start, when nothing has run, and then whenever every process has
  /// reported once more, which each does once a second.
  using Progress = std::function<void(suture::Duration ran, const std::vector<suture::Report>&)>;

  /// `programs` is the folder of the executables; `folder` is where they run and record.
  Crew(Plan& plan, Network& network, std::optional<Break> cutOff, std::filesystem::path programs,
       std::filesystem::path folder);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Runs for `length` and ends every process, whatever happens. It never takes longer than that
  /// and some seconds, unless this process gets no processor time to make the break.
  CrewResult run(suture::Duration length, const Progress& progress);

 private:
  struct Workstation {
    ChildProcess process;
    suture::Report report;  ///< the newest
    std::uint64_t reports = 0;
    bool started = false;
  };

  void startManager();
  void startWorkstations();
  void awaitStarted();
  void watch(suture::Duration length, const Progress& progress);
  suture::Time endOfRun(suture::Time began, suture::Duration length) const;
  suture::Time breakOrMend(suture::Time began);
  void cut();
  void mend();
  void end();

  /// Handles what happens until `until`, at least once.
  void pump(suture::Time until);
  void readSignals();
  void readOutputs();
  void readManager();
  void noticeProgram(const ChildProcess& process);
  void handle(Workstation& workstation, const std::string& line);
  void noticeEnds();
  template <class Ended>
  void pumpUntil(suture::Time deadline, const Ended& ended);
  void endAll(const std::vector<ChildProcess*>& processes);

  bool over() const { return result_.interrupted || !result_.failures.empty(); }
  /// Returns true while a process is cut off, and shortly after: what is lost then is lost on
  /// purpose.
  bool expectsLosses() const;
  bool missesConnections() const;
  bool allStarted() const;
  std::uint64_t reportsOfEach() const;
  const ChildProcess& workstation(const std::string& process) const;
  std::vector<ChildProcess*> processes();
  std::vector<suture::Report> reports() const;

  Plan& plan_;
  Network& network_;
  const std::optional<Break> cutOff_;
  const std::filesystem::path programs_, folder_;
  int signals_;
  std::unique_ptr<ChildProcess> manager_;
  bool managerReady_ = false;
  std::set<std::pair<dev_t, ino_t>> hashed_;  // files of programs
  std::vector<std::unique_ptr<Workstation>> workstations_;
  std::vector<const ChildProcess*> ended_;
  std::optional<suture::Time> broken_;  // since then a process is cut off
  bool ending_ = false;
  CrewResult result_;
};

}  // namespace demo
