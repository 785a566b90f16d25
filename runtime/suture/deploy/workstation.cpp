#include <suture/base/nearest.h>
#include <suture/base/plain.h>
#include <suture/deploy/check.h>
#include <suture/deploy/host.h>
#include <suture/deploy/number_option.h>
#include <suture/deploy/report_descriptor.h>
#include <suture/deploy/report_writer.h>
#include <suture/deploy/workstation.h>
#include <suture/lane/lane_kind.h>
#include <suture/loop/descriptor_limit.h>
#include <suture/loop/signal_wait.h>
#include <suture/loop/standard_streams.h>
#include <suture/observe/observe.h>
#include <suture/session/telling.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace suture {
namespace {

using namespace std::chrono_literals;

// Says how soon a failure is noticed.
constexpr Duration kWatchInterval = 50ms;
// The processes of a system that is shut down end one after the other, so what this one lost of
// others this shortly before its own end was no accident.
constexpr Duration kShutdown = 500ms;
// Limits the wait for a slow reader at the end.
constexpr Duration kLastWords = 500ms;
constexpr int kFailed = 1, kMisused = 2;  // exit status

struct Options {
  std::string deployment;
  std::string process;
  double seconds = 0;
  double reportInterval = 1;
  std::string reportTo;
  std::string reportForm = "json";
  bool messages = false;
  bool check = false;
};

auto numberFrom(double least, double most) {
  return [=](const std::string& text) { return whyNotNumber(text, least, most); };
}

void declare(CLI::App& app, Options& options) {
  app.add_option("--deployment", options.deployment, "The deployment file (JSON); it is needed");
  app.add_option("--process", options.process,
                 "Which of its processes this is; may be left out if there is one only");
  CLI::Option* const check =
      app.add_flag("--check", options.check,
                   "Run nothing, but tell every mistake of the whole file, or of --process");
  app.add_option("--seconds", options.seconds, "How long to run; 0: until told to stop")
      ->check(numberFrom(0, 1e9))
      ->excludes(check);
  CLI::Option* const reportTo =
      app.add_option("--report-fd", options.reportTo,
                     "Where to write reports: a file descriptor, or - for standard output")
          ->check(whyNotWritable)
          ->excludes(check);
  app.add_option("--report-interval", options.reportInterval, "Seconds between two reports")
      ->capture_default_str()
      ->check(numberFrom(0.01, 1e6))
      ->needs(reportTo);
  app.add_option("--report-form", options.reportForm,
                 "json: an object a line; text: lines for people")
      ->capture_default_str()
      ->check(CLI::IsMember({"json", "text"}))
      ->needs(reportTo);
  app.add_flag("--messages", options.messages,
               "Tell on standard error what components say: their status, warning and error")
      ->excludes(check);
}

/// Returns "; did you mean '--deployment'?" for the nearest option to one that there is not.
std::string nearestOption(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::string nearest = nearestName(word, names);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

/// Returns the exit status, which a reader that has gone does not change.
int print(const std::string& text) {
  try {
    loop::writeOut(text);
    return 0;
  } catch (const SetupError& lost) {
    std::fprintf(stderr, "%s\n", lost.what());
    return kFailed;
  }
}

/// Returns the exit status if the command line ends the program.
std::optional<int> read(CLI::App& app, Options& options, int argc, const char* const* argv) {
  std::string problem;
  try {
    app.parse(argc, argv);
    if (!options.deployment.empty()) return std::nullopt;
    problem = "--deployment FILE is missing: it says what this process runs";
  } catch (const CLI::ExtrasError& error) {
    const std::string word = app.remaining().empty() ? "" : app.remaining().front();
    problem = "there is no option '" + word + "'" + nearestOption(app, word);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return print(app.help());
    problem = error.what();
  }
  std::fprintf(stderr, "%s\n`%s --help` tells what there is.\n", problem.c_str(), argv[0]);
  return kMisused;
}

/// Runs one host to its end and reports what happens.
class Run {
 public:
  Run(Host& host, const loop::SignalWait& signals, const Options& options)
      : host_(host),
        signals_(signals),
        reports_(descriptorIn(options.reportTo).value_or(-1), options.reportForm == "text"
                                                                  ? ReportWriter::Form::Text
                                                                  : ReportWriter::Form::Json),
        toldByReports_(!options.reportTo.empty()),
        interval_(fromSeconds(options.reportInterval)),
        end_(options.seconds > 0 ? began_ + fromSeconds(options.seconds) : Time::max()) {}

  int untilEnd() {
    reports_.started();
    if (!toldByReports_) tellWhatRuns();
    Time reportDue = began_ + interval_;
    while (now() < end_) {
      if (signals_.endBefore(std::min({reportDue, end_, now() + kWatchInterval}))) break;
      watch();
      reports_.flush();
      tellOfReports();
      const Time looked = now();
      if (looked < reportDue || looked >= end_) continue;  // the last report comes after this
      reports_.report(observe(host_.manager(), began_));
      reportDue = std::max(reportDue + interval_, now());  // those of a pause are left out
    }
    const Time ending = now();
    host_.endBlackBox();
    watch(true);
    reports_.flush(kLastWords);
    reports_.report(observe(host_.manager(), began_));
    host_.stop();
    watchTheStop();
    reports_.flush(kLastWords);
    tellOfReports();
    const bool failed =
        reportsLost_ || std::any_of(known_.begin(), known_.end(), [&](const Known& one) {
          return one.trouble.failure && (!one.trouble.loss || one.seen + kShutdown < ending);
        });
    return failed ? kFailed : 0;
  }

 private:
  struct Known {
    Trouble trouble;
    Time seen;
  };

  void watch(bool ending = false) {
    for (const std::string& line : host_.news()) tell(line);
    const std::vector<Trouble> present = host_.troubles();
    std::erase_if(known_, [&](const Known& one) {
      const bool stays = std::any_of(present.begin(), present.end(), [&](const Trouble& trouble) {
        return trouble.subject == one.trouble.subject;
      });
      if (!stays && host_.exists(one.trouble)) tell(one.trouble.subject + " " + kIsThereAgain);
      return !stays;
    });
    notice(present, ending);
  }

  // What a component does last may fail too: the disk of a collector may be full. Connections end
  // now, which is no recovery of those that were lost.
  void watchTheStop() {
    for (const std::string& line : host_.news()) tell(line);
    notice(host_.troubles(), true);
  }

  // While this process ends, losses due to other processes are no news.
  void notice(const std::vector<Trouble>& present, bool ending) {
    for (const Trouble& trouble : present) {
      if (ending && trouble.loss) continue;
      auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& one) {
        return one.trouble.subject == trouble.subject;
      });
      if (known == known_.end()) {
        tell(trouble, trouble.text);
        known_.push_back({trouble, now()});
        known = known_.end() - 1;
        known->trouble.more.clear();
      }
      if (trouble.more == known->trouble.more) continue;
      known->trouble.more = trouble.more;
      if (!trouble.more.empty()) tell(trouble, trouble.more);
    }
  }

  void tellWhatRuns() const {
    const std::vector<std::string> names = host_.componentNames();
    tell("runs " + (names.empty() ? "no component" : listNames(names)));
  }

  void tell(const Trouble& trouble, const std::string& what) {
    const std::string text = trouble.subject + " " + what;
    tell(text);
    if (trouble.failure) reports_.failure(text, trouble.loss);
  }

  void tellOfReports() {
    const std::string problem = reports_.takeProblem();
    if (problem.empty()) return;
    tell(problem);
    reportsLost_ = true;
  }

  void tell(const std::string& text) const {
    std::fprintf(stderr, "%s: %s\n", host_.manager().process().c_str(), text.c_str());
  }

  Host& host_;
  const loop::SignalWait& signals_;
  ReportWriter reports_;
  const bool toldByReports_;
  const Duration interval_;
  const Time began_ = now();
  const Time end_;
  std::vector<Known> known_;
  bool reportsLost_ = false;
};

std::string processOf(const Deployment& deployment, const Options& options) {
  if (!options.process.empty()) return options.process;
  if (deployment.processes().size() == 1) return deployment.processes().front().name;
  std::vector<std::string> names;
  for (const ProcessEntry& process : deployment.processes()) names.push_back(process.name);
  throw DocumentError({deployment.document().locate(
      "/processes",
      "there are several processes: " + listNames(names) + "; say which one with --process")});
}

/// Returns false if the process has been told to end meanwhile: the caller must stop what has been
/// started.
bool start(Host& host, const loop::SignalWait& signals) {
  std::atomic<bool> toEnd{false};
  {
    const loop::OnToldToEnd told(signals, [&] {
      toEnd = true;
      host.giveUp();
    });
    try {
      host.start();
    } catch (const DocumentError&) {
      if (!toEnd) throw;
    }
  }  // who waited may have taken the signal until here, and nobody else will see it
  return !toEnd;
}

void tell(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) std::fprintf(stderr, "%s\n", line.c_str());
}

int check(const Options& options, std::span<const ComponentClass> classes,
          const AddedLanes& added) {
  const Checked found = checkDeployment(options.deployment, options.process, classes, added);
  tell(found.warnings);
  if (!found.problems.empty()) {
    tell({explained(DocumentError(found.problems).what())});
    return kFailed;
  }
  return print(options.deployment + ": no mistake in " + found.subject + "\n");
}

int runWorkstation(const Options& options, std::span<const ComponentClass> classes,
                   const AddedLanes& added) {
  loop::allowAllDescriptors();
  const loop::SignalWait signals;
  auto told = std::make_optional<loop::OnToldToEnd>(signals, [] { _exit(0); });  // nothing runs yet
  const Deployment deployment(JsonDocument::read(options.deployment));
  Host host(deployment, processOf(deployment, options), classes);
  // Without a manager nothing travels, and a process has no lanes.
  if (added != nullptr && !deployment.manager().empty()) {
    for (auto& lane : added()) host.addLane(std::move(lane));
  }
  if (options.messages) host.listenToMessages();
  tell(host.news());
  told.reset();
  if (!start(host, signals)) return 0;
  return Run(host, signals, options).untilEnd();
}

}  // namespace

int workstationMain(int argc, const char* const* argv, std::span<const ComponentClass> classes,
                    const AddedLanes& added) {
  std::signal(SIGPIPE, SIG_IGN);
  Options options;
  CLI::App app("Runs one process of a deployment.");
  declare(app, options);
  if (const std::optional<int> status = read(app, options, argc, argv)) return *status;
  loop::openStandardDescriptors();  // --report-fd has been refused one that was closed
  try {
    return options.check ? check(options, classes, added) : runWorkstation(options, classes, added);
  } catch (const std::exception& error) {
    tell({explained(error.what())});
    return kFailed;
  }
}

}  // namespace suture
