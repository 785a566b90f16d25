#include <fmt/format.h>
#include <suture/base/errors.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/compiler/parts.h"
#include "bench/compiler/timed_command.h"
#include "bench/figures/table.h"
#include "paths.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

constexpr char kContract[] = "arm/arm";
constexpr const char* kTypes[] = {"robot_types/cartesian",       "robot_types/joint_commands",
                                  "robot_types/joints",          "robot_types/messages",
                                  "robot_types/operating_state", "robot_types/pose"};
constexpr const char* kHandwritten[] = {"arm_client.cpp", "arm_server.cpp"};
constexpr const char* kHandwrittenTypes[] = {"cartesian_conversions.cpp", "joint_conversions.cpp",
                                             "pose_conversions.cpp"};

/// Says how this build compiles the generated source of the contract, for any source.
class CompileCall {
 public:
  CompileCall() {
    const fs::path file = fs::path(paths::kBuild) / "compile_commands.json";
    std::ifstream in(file);
    const auto commands = nlohmann::json::parse(in, nullptr, false);
    if (!commands.is_array()) {
      throw suture::SetupError("the compiler's calls in " + file.string(), "there are none",
                               "Configure with the preset release");
    }
    for (const auto& one : commands) {
      const std::string source = one.at("file");
      // A build in units compiles the contract with others of its target.
      if (source.find("/robots_contracts.dir/") == std::string::npos) continue;
      words_ = wordsOf(one.at("command"));
      generated_ = fs::path(paths::kBuild) / "generated";
      return;
    }
    throw suture::SetupError("how " + std::string(kContract) + " is compiled",
                             "the build does not compile it", "Build the preset release");
  }

  Command operator()(const fs::path& source) const {
    Command command;
    for (std::size_t i = 0; i + 1 < words_.size(); ++i) {
      const bool paired = words_[i] == "-o" || words_[i] == "-c";
      if (paired) {
        ++i;
      } else {
        command.push_back(words_[i]);
      }
    }
    command.push_back("-I" + (fs::path(paths::kSource) / "tests").string());
    for (const char* const word : {"-c", "-o", "object.o"}) command.emplace_back(word);
    command.push_back(source.string());
    return command;
  }
  void addGenerated(std::vector<Command>& calls, const char* stem) const {
    for (const char* const suffix : {".suture.cpp", ".wire.cpp"}) {
      calls.push_back((*this)(generated_ / (std::string(stem) + suffix)));
    }
  }
  Command handwritten(const char* source) const {
    return (*this)(fs::path(paths::kSource) / "tests/bench/compiler/handwritten" / source);
  }

 private:
  Command words_;
  fs::path generated_;
};

/// Writes a user's file that includes one header of the interface and nothing else.
fs::path userFile(const fs::path& scratch, const char* name, const char* header) {
  fs::path file = scratch / name;
  std::ofstream(file) << "#include \"" << header << "\"\n";
  return file;
}

void measureCompiling(const CompilerOptions& options, Report& report, Table& table) {
  const CompileCall call;
  const fs::path& scratch = options.scratch;
  std::vector<Command> generated, types, handwritten, handwrittenTypes;
  call.addGenerated(generated, kContract);
  for (const char* const stem : kTypes) call.addGenerated(types, stem);
  for (const char* const source : kHandwritten) handwritten.push_back(call.handwritten(source));
  for (const char* const source : kHandwrittenTypes)
    handwrittenTypes.push_back(call.handwritten(source));

  Comparison sources, users;
  const std::size_t contract = sources.add(generated, scratch / "contract");
  const std::size_t hand = sources.add(handwritten, scratch / "hand");
  const std::size_t contractTypes = sources.add(types, scratch / "types");
  const std::size_t handTypes = sources.add(handwrittenTypes, scratch / "hand_types");
  sources.run(options.compileRounds(), "compiling the arm interface");
  const std::size_t plain =
      users.add({call(userFile(scratch, "plain.cpp", "arm/arm.h"))}, scratch / "plain");
  const std::size_t proxy =
      users.add({call(userFile(scratch, "proxy.cpp", "arm/arm.suture.h"))}, scratch / "proxy");
  users.run(options.toolRounds(), "compiling a user's file");

  const auto add = [&](const Comparison& from, const char* title, const char* figure,
                       std::size_t contestant) {
    const Statistics seconds = from.seconds(contestant);
    report.add(std::string("compile.") + figure, "s", seconds);
    table.row({title, number(seconds.p50, 2), number(seconds.min, 2), number(seconds.max, 2)});
    return seconds.p50;
  };
  const double ours = add(sources, "generated from the contract", "contract", contract);
  const double byHand = add(sources, "client and server by hand", "handwritten", hand);
  const double oursTypes = add(sources, "generated from its types", "types", contractTypes);
  const double byHandTypes = add(sources, "conversions by hand", "handwritten_types", handTypes);
  add(users, "a user's file, contract alone", "user.contract", plain);
  add(users, "a user's file, proxy header", "user.proxy", proxy);
  report.add("compile.ratio", "x", ours / byHand);
  report.add("compile.ratio_with_types", "x", (ours + oursTypes) / (byHand + byHandTypes));
  report.add("compile.user.extra", "s", users.secondsBeyond(plain, proxy).p50);
}

}  // namespace

std::string compileRows(const CompilerOptions& options, Report& report) {
  Table table(1);
  table.row({"compiling the complete arm interface, processor time, s", "p50", "min", "max"});
  table.line();
  try {
    measureCompiling(options, report, table);
  } catch (const suture::SetupError& error) {
    report.addUnavailable("compile", error.what());
    return fmt::format("Compiling cannot be measured: {}\n", error.what());
  }
  return table.toString() +
         fmt::format(
             "generated / by hand {:.2f}, with the types' conversions {:.2f}; a user pays "
             "{:.2f} s for the proxy\n",
             report.find("compile.ratio")->value, report.find("compile.ratio_with_types")->value,
             report.find("compile.user.extra")->value);
}

}  // namespace bench
