#include <fmt/format.h>
#include <suture/base/errors.h>

#include <algorithm>
#include <fstream>

#include "bench/compiler/parts.h"
#include "bench/compiler/timed_command.h"
#include "bench/figures/table.h"
#include "paths.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeaders = 10;

/// Says how the build calls suturec for the components of the tree.
struct Call {
  Command headers;    ///< the largest ones
  Command options;    ///< those before "--", without --out
  Command arguments;  ///< those behind it
};

Call readCall(const char* file) {
  std::ifstream in(file);
  if (!in) {
    throw suture::SetupError("the call of suturec in " + std::string(file), "there is none",
                             "Install LLVM 19 with .ci/install compiler and build again");
  }
  Call call;
  bool ours = true;
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    if (line == "--") {
      ours = false;
    } else if (!ours) {
      call.arguments.push_back(line);
    } else if (line == "--out") {
      std::getline(in, line);
    } else {
      (line.ends_with(".h") ? call.headers : call.options).push_back(line);
    }
  }
  std::stable_sort(call.headers.begin(), call.headers.end(), [](const auto& a, const auto& b) {
    return fs::file_size(a) > fs::file_size(b);
  });
  call.headers.resize(std::min(call.headers.size(), kHeaders));
  return call;
}

void writeFile(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

/// Writes the same translation unit as suturec's for other programs: where suturec puts an include
/// of X.h in the place of each X.suture.h, they find a file that does.
fs::path writeUnit(const Call& call, const fs::path& folder) {
  std::string text;
  for (const std::string& header : call.headers) text += "#include \"" + header + "\"\n";
  writeFile(folder / "unit.cpp", text);
  const fs::path base = fs::path(paths::kSource) / "components";
  for (const auto& entry : fs::recursive_directory_iterator(base)) {
    if (entry.path().extension() != ".h") continue;
    fs::path generated = folder / fs::relative(entry.path(), base);
    generated.replace_extension(".suture.h");
    writeFile(generated, "#pragma once\n#include \"" + entry.path().string() +
                             "\"\n#include <suture/component/provided.h>\n"
                             "#include <suture/component/required.h>\n");
  }
  return folder / "unit.cpp";
}

Command joinedCommand(Command first, const Command& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

void measureTool(const CompilerOptions& options, Report& report, Table& table) {
  const Call call = readCall(paths::kResponseFile);
  const fs::path folder = options.scratch / "unit";
  const std::string unit = writeUnit(call, folder);
  const Command own = {"-DSUTUREC", "-I" + folder.string()};

  Command suturec = joinedCommand({paths::kSuturec}, call.options);
  suturec = joinedCommand(suturec, {"--out", (options.scratch / "suturec" / "out").string()});
  suturec = joinedCommand(joinedCommand(suturec, call.headers), {"--"});
  suturec = joinedCommand(suturec, call.arguments);
  const Command resources = {"-resource-dir=" + std::string(paths::kClangResources)};
  Command consumer = joinedCommand({paths::kEmptyConsumer, unit, "--"}, own);
  consumer = joinedCommand(joinedCommand(consumer, resources), call.arguments);
  // Bodies call what is generated, so clang++ has to see the real generated headers.
  const Command clang = joinedCommand({paths::kClang, "-fsyntax-only", unit}, call.arguments);

  Comparison comparison;
  const std::size_t empty = comparison.add({consumer}, options.scratch / "consumer");
  const std::size_t ours = comparison.add({suturec}, options.scratch / "suturec");
  const std::size_t syntax = comparison.add({clang}, options.scratch / "clang");
  comparison.run(options.toolRounds(), "suturec");

  const auto add = [&](const char* title, const char* figure, std::size_t contestant) {
    const Statistics seconds = comparison.seconds(contestant);
    report.add(std::string("tool.") + figure, "s", seconds);
    report.add(std::string("tool.") + figure + ".memory", "MB", comparison.megabytes(contestant));
    table.row({title, number(seconds.p50, 3), number(seconds.min, 3), number(seconds.max, 3),
               number(comparison.megabytes(contestant), 0)});
  };
  add("empty libTooling consumer, bodies skipped", "consumer", empty);
  add("suturec", "suturec", ours);
  add("clang++-19 -fsyntax-only", "clang", syntax);
  const double mine = comparison.seconds(ours).p50;
  report.add("tool.ratio.consumer", "x", mine / comparison.seconds(empty).p50);
  report.add("tool.ratio.clang", "x", mine / comparison.seconds(syntax).p50);
}

}  // namespace

std::string toolRows(const CompilerOptions& options, Report& report) {
  Table table(1);
  table.row({"the ten largest headers, processor time, s", "p50", "min", "max", "MB"});
  table.line();
  try {
    measureTool(options, report, table);
  } catch (const suture::SetupError& error) {
    report.addUnavailable("tool", error.what());
    return fmt::format("suturec cannot be measured: {}\n", error.what());
  }
  return table.toString() + fmt::format("suturec / consumer {:.3f}, suturec / clang++ {:.3f}\n",
                                        report.find("tool.ratio.consumer")->value,
                                        report.find("tool.ratio.clang")->value);
}

}  // namespace bench
