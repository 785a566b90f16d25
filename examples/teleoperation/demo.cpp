// suture-demo: two masters drive two slaves, in one process or across two, and the run is judged.

#include <suture/base/errors.h>
#include <suture/lane/lane.h>
#include <suture/lane/lanes.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <system_error>
#include <vector>

#include "following_watch.h"
#include "picture/knot_picture.h"
#include "result_file.h"
#include "run/break.h"
#include "run/plan.h"
#include "run/processes.h"
#include "run/space.h"
#include "run/topologies.h"
#include "tables/comparison.h"
#include "tables/screen.h"
#include "verdict.h"

namespace {

namespace fs = std::filesystem;

constexpr int kInterrupted = 130;  // what a shell says of a program that Ctrl-C ended

/// A RunFolder is the folder where a run records; it is removed with this object.
class RunFolder {
 public:
  RunFolder() {
    std::error_code unknown;
    std::string name = fs::temp_directory_path(unknown) / "suture-demo-XXXXXX";
    if (unknown || mkdtemp(name.data()) == nullptr) {
      throw suture::SetupError("make a folder for what this run records",
                               unknown ? unknown.message() : name + ": " + std::strerror(errno),
                               "Let TMPDIR name a folder where this user may write");
    }
    path_ = name;
  }
  ~RunFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Call this after all other options are declared. It refuses each of them beside --compare, which
/// runs nothing, so that no other option could have an effect.
void declareComparison(CLI::App& app, demo::Options& options) {
  const auto others = app.get_options(
      [](const CLI::Option* one) { return one->get_lnames() != std::vector<std::string>{"help"}; });
  CLI::Option* const compare =
      app.add_option(
             "--compare", options.compare,
             "Run nothing, but print what differs between two topologies, by their files alone")
          ->type_name("NAME|FILE.json NAME|FILE.json")
          ->expected(2);
  for (CLI::Option* other : others) compare->excludes(other);
}

void declare(CLI::App& app, demo::Options& options) {
  app.add_option("--topology", options.topology,
                 "Which processes there are, and what runs in them: one of those below, or a "
                 "deployment file")
      ->type_name("NAME|FILE.json")
      ->capture_default_str();
  std::vector<std::string> lanes = suture::laneNames(suture::makeLanes());
  lanes.insert(lanes.begin(), suture::Lane::Auto.name);
  app.add_option("--lane", options.lane,
                 "auto: the fastest lane that fits; shm: shared memory, rpc: Cap'n Proto RPC, both "
                 "even within a process, but for an arm and its drives")
      ->capture_default_str()
      ->check(CLI::IsMember(lanes));
  app.add_option(
         "--network", options.network,
         "What processes talk over. auto: namespaces where they can be made (as root), else "
         "tcp; unix with lane shm. unix: Unix sockets, so that lane auto is shared memory; "
         "tcp, tls: on loopback; namespaces: TLS, each process in a network namespace of its "
         "own, with a cable to a switch")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "unix", "tcp", "tls", "namespaces"}));
  app.add_option(
         "--break", options.cutOff,
         "Cut a process off during the run: vision@4s, or vision@4s+1500ms (without a length, "
         "one second). Its cable is pulled; without namespaces it is frozen. The slaves that "
         "depend on it have to hold")
      ->type_name("PROCESS@TIME");
  app.add_option(
         "--stop", options.stop,
         "Press the emergency stop during the run: 6s, or 6s+1500ms (without a length, it is "
         "released after one second)")
      ->type_name("TIME")
      ->excludes("--break");
  app.add_option("--seconds", options.seconds,
                 fmt::format("How long to run. Until it is judged, a run is recorded in a folder "
                             "below TMPDIR: about {:g} MB a second with four arms at 1000 Hz",
                             demo::kUsualRecording))
      ->capture_default_str()
      ->check(CLI::Range(1.0, 86400.0));
  app.add_option(
         "--rate", options.rate,
         "Cycles of teleoperations a second, Hz. Arms, their drives and recorders run 1.5 times as "
         "often. Cameras and what looks at their images keep their periods, and connections keep "
         "their max_age. Below 100 Hz a slave would move further in one cycle than it may be off")
      ->capture_default_str()
      ->check(CLI::Range(100.0, 10000.0));
  app.add_option("--dynamics", options.dynamics,
                 "What the drives simulate. Lag: joints without mass that trail their goals by a "
                 "time constant, as in the files; RigidBody: motors move bodies that have mass, "
                 "against gravity, friction and stops")
      ->check(CLI::IsMember({"Lag", "RigidBody"}));
  app.add_option("--json", options.json, "Also write all figures to this file");
  app.add_option(
      "--picture", options.picture,
      "Where a knot is placed: write to this PNG the scene at the end as the endoscope "
      "sees it, how the knot came to its target, and the processes with the ages of what "
      "went between them");
  declareComparison(app, options);
}

/// Returns false, with the reason on standard error, if `work` throws.
bool succeeds(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return false;
  }
}

fs::path programs() { return fs::read_symlink("/proc/self/exe").parent_path(); }

suture::Deployment deploymentOf(const fs::path& topology) {
  return suture::Deployment(suture::JsonDocument::read(topology));
}

/// Prints what the files say and runs nothing.
void printComparison(const std::vector<std::string>& names, const demo::Topologies& topologies) {
  const auto first = deploymentOf(topologies.find(names.at(0)));
  const auto second = deploymentOf(topologies.find(names.at(1)));
  const demo::ProgramHash program = demo::hashProgram(programs() / "suture-workstation");
  std::printf("%s\nOne program runs every process of both: %s, SHA-256\n%s\n",
              describe(demo::compare(first, second), names.at(0), names.at(1)).c_str(),
              program.name.c_str(), program.sha256.c_str());
}

int run(const demo::Options& options, const demo::Topologies& topologies) {
  demo::blockEndSignals();
  const RunFolder folder;
  demo::Network network(options.network, options.lane);
  demo::Plan plan(options, network, topologies.find(options.topology), folder.path());
  if (!options.picture.empty()) demo::requireKnot(plan);
  const suture::Duration length = demo::lengthOf(options);
  demo::requireSpace(plan, length, folder.path());
  const auto cutOff = demo::parseBreak(options.cutOff, plan, network, length);
  demo::Watches watches(plan);
  demo::Crew crew(plan, network, cutOff, programs(), folder.path());
  demo::Screen screen;
  screen.begin(options, plan, network);
  const demo::CrewResult result = crew.run(length, [&](auto ran, const auto& reports) {
    screen.progress(ran, reports, watches.worstError());
  });
  const demo::Verdict verdict = demo::judgeRun(plan, cutOff, result, watches);
  screen.end(plan, result, verdict);
  const bool wrote = options.json.empty() || succeeds([&] {
                       demo::writeResult(options.json, options, plan, network, result, verdict);
                     });
  const bool drew = options.picture.empty() || succeeds([&] {
                      demo::drawKnot(options.picture, demo::requireKnot(plan),
                                     demo::processGraph(plan, verdict.connections), result.outage);
                    });
  if (result.interrupted) return kInterrupted;
  return verdict.passed() && wrote && drew ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  demo::Options options;
  CLI::App app(
      "Two masters drive two slaves through code that suturec wrote from plain C++ headers. Exit "
      "status 0: no process died, every connection used the lane it was given, each slave "
      "travelled at least 30 mm and followed the law within 1 mm and 1 degree at p99, for 90 % of "
      "the time in which it had to, none jumped, a knot came to 1 mm from its target, slaves held "
      "while a "
      "process "
      "that they depend on was cut off or the emergency stop was pressed, and the files that were "
      "asked for are written.");
  if (!succeeds([&] { declare(app, options); })) return 1;
  const auto topologies = demo::Topologies::besideProgramsIn(programs());
  app.footer("Topologies:\n" + topologies.list());
  CLI11_PARSE(app, argc, argv);
  if (!options.compare.empty()) {
    return succeeds([&] { printComparison(options.compare, topologies); }) ? 0 : 1;
  }
  int status = 1;
  succeeds([&] { status = run(options, topologies); });
  return status;
}
