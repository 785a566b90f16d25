#include <fmt/format.h>
#include <suture/base/errors.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "bench/compiler/ninja_build.h"
#include "bench/compiler/parts.h"
#include "bench/figures/table.h"
#include "bench/progress.h"
#include "paths.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

void edit(const fs::path& file, const std::string& old, const std::string& replacement) {
  std::ifstream in(file);
  std::string text(std::istreambuf_iterator<char>(in), {});
  const auto at = text.find(old);
  if (at == std::string::npos) {
    throw suture::SetupError("editing " + file.string(), "there is no '" + old + "' in it",
                             "Keep tests/bench/compiler/project as it was");
  }
  in.close();
  std::ofstream(file) << text.replace(at, old.size(), replacement);
}

/// Returns how many of `objects` are not among `allowed`.
std::size_t surplus(const std::set<std::string>& objects, const std::set<std::string>& allowed) {
  return static_cast<std::size_t>(
      std::count_if(objects.begin(), objects.end(),
                    [&](const std::string& object) { return !allowed.contains(object); }));
}

class RebuildRows {
 public:
  RebuildRows(Report& report, Table& table) : report_(report), table_(table) {}

  void add(const char* title, const std::string& figure, const NinjaBuild::Ran& ran,
           const std::set<std::string>& allowed) {
    const std::size_t others = surplus(ran.objects, allowed);
    const auto count = [&](const char* what, const char* unit, std::size_t number) {
      report_.add("rebuild." + figure + "." + what, unit, static_cast<double>(number));
    };
    count("generators", "runs", ran.generators);
    count("rewritten", "files", ran.rewritten);
    count("compiled", "files", ran.objects.size());
    count("surplus", "files", others);
    table_.row({title, std::to_string(ran.generators), std::to_string(ran.rewritten),
                std::to_string(ran.objects.size()), std::to_string(others)});
  }

 private:
  Report& report_;
  Table& table_;
};

void measureRebuilding(const CompilerOptions& options, Report& report, Table& table) {
  const fs::path source = options.scratch / "rebuild";
  fs::copy(fs::path(paths::kSource) / "tests/bench/compiler/project", source,
           fs::copy_options::recursive);
  const fs::path build = paths::kBuild;
  progress("building a project of two types");
  NinjaBuild project(
      source, source / "build",
      {{"SUTUREC", paths::kSuturec},
       {"SUTURE_CMAKE", (fs::path(paths::kSource) / "compiler/cmake").string()},
       {"SUTURE_INCLUDES", (build / "include").string() + ";" + (build / "schemas").string() + ";" +
                               (fs::path(paths::kSource) / "schemas").string()}});
  const fs::path length = source / "parts/length.h";
  project.build("update-lock");
  project.build();

  RebuildRows rows(report, table);
  rows.add("no edit", "none", project.build(), {});

  const std::set<std::string> header = {"parts/length.h"};
  edit(length, "struct SUTURE", "// A plain comment.\nstruct SUTURE");
  const auto includeHeader = project.including(header);
  rows.add("a comment in length.h", "comment", project.build(), includeHeader);

  edit(length, "double value = 0;", "double value = 0;\n  double error = 0;");
  const std::set<std::string> files = {"parts/length.h", "parts/length.suture.h",
                                       "parts/length.capnp.h"};
  project.build("update-lock");
  auto allowed = project.including(files);
  const NinjaBuild::Ran ran = project.build();
  allowed.merge(project.including(files));
  rows.add("a field more in Length", "field", ran, allowed);
  progress("");
}

}  // namespace

std::string rebuildRows(const CompilerOptions& options, Report& report) {
  Table table(1);
  table.row({"a build after", "suturec runs", "rewritten", "compiled", "of them needlessly"});
  table.line();
  try {
    measureRebuilding(options, report, table);
  } catch (const suture::SetupError& error) {
    report.addUnavailable("rebuild", error.what());
    return fmt::format("Rebuilding cannot be measured: {}\n", error.what());
  }
  return table.toString();
}

}  // namespace bench
