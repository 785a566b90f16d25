#include "compiler/driver/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "compiler/driver/explain.h"
#include "compiler/driver/list_outputs.h"

namespace suture::compiler::driver {
namespace {

// Holds the two parts of the arguments: what stands behind "--", on the command line or in a
// response file, goes to clang.
struct Split {
  std::vector<std::string> own, clang;

  void append(const std::vector<std::string>& arguments) {
    std::vector<std::string>* side = &own;
    for (const std::string& argument : arguments) {
      if (side == &own && argument == "--") {
        side = &clang;
      } else if (side == &own && argument.size() > 1 && argument[0] == '@') {
        append(responseFile(argument.substr(1)));
      } else {
        side->push_back(argument);
      }
    }
  }

  // Takes one argument a line, literally, since no shell stands between the build system and us.
  static std::vector<std::string> responseFile(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
      throw std::runtime_error("cannot read the response file '" + path + "'; correct its path");
    }
    std::vector<std::string> arguments;
    for (std::string line; std::getline(file, line);) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (line.starts_with('@')) {
        throw std::runtime_error("response file '" + path +
                                 "' names another; write the arguments of that one into it");
      }
      if (!line.empty()) arguments.push_back(line);
    }
    return arguments;
  }
};

// Reads "arm/arm.h=3".
std::pair<std::string, unsigned> sourcesOf(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  const std::string digits = equals == std::string::npos ? "" : text.substr(equals + 1);
  const bool isNumber = !digits.empty() && digits.size() < 4 &&
                        digits.find_first_not_of("0123456789") == std::string::npos;
  const unsigned count = isNumber ? static_cast<unsigned>(std::stoul(digits)) : 0;
  if (count == 0) {
    throw CLI::ValidationError("--sources",
                               "'" + text + "' is not HEADER=N, where N is from 1 to 999");
  }
  return {text.substr(0, equals), count};
}

void declare(CLI::App& app, Options& options) {
  app.add_option("headers", options.headers, "Annotated headers of one target");
  app.add_option("--target-name", options.targetName, "Name of the target, for messages");
  app.add_option("--base-dir", options.baseDirectory, "Headers are known by their path below it");
  app.add_option("--out", options.outputDirectory, "Folder for what is generated");
  app.add_option("--lock-dir", options.lockDirectories, "Folder of locked schemas; own first")
      ->allow_extra_args(false);
  app.add_option(
      "--components-file", options.componentsFile,
      "Source file below --out for suture_components(), through which a deployment finds "
      "the components of a shared library");
  app.add_option_function<std::vector<std::string>>(
         "--sources",
         [&options](const std::vector<std::string>& all) {
           for (const std::string& one : all) options.sources.insert(sourcesOf(one));
         },
         "HEADER=N: write N sources of each kind for a big header, named by its path")
      ->allow_extra_args(false);
  app.add_option("--depfile", options.depfile, "Make rule that lists every file read");
  app.add_option("--stamp", options.stamp, "File touched after a run without errors");
  app.add_option("--resource-dir", options.resourceDirectory, "Clang's own headers");
  app.add_option("--project", options.project, "Owner of new wire ids");
  app.add_option("--lock-command", options.lockCommand,
                 "The command that messages name for updating the lock");
  app.add_option("--break-command", options.breakCommand,
                 "The command that messages name for updating the lock in spite of breaks");
  auto* update =
      app.add_flag("--update-lock", options.updateLock, "Write the lock instead of checking it");
  app.add_flag("--accept-break", options.acceptBreak,
               "Take breaking edits into the lock and raise the contracts' major")
      ->needs(update);
  app.add_option("--new-id", options.newIds, "Give this name an id anew, after a lock was copied")
      ->needs(update)
      ->allow_extra_args(false);
  app.set_version_flag("--version", "suturec " SUTUREC_VERSION, "Print the version, and end");
  app.add_option("--explain", options.explain, "Print the page of a diagnostic, and end");
  app.add_flag("--list-outputs", options.listOutputs,
               "Print the endings of what a header gives, each behind its use, and end");
  app.add_flag("--fix", options.fix, "Apply the fix-its of errors and warnings to the headers");
  app.add_option("--fatal", options.fatalWarnings,
                 "Slug of a warning that is an error here, or all")
      ->allow_extra_args(false);
}

}  // namespace

Parsed parseOptions(const std::vector<std::string>& arguments) {
  Split split;
  split.append(arguments);
  Options options;
  options.clangArguments = std::move(split.clang);
  CLI::App app{
      "Reads annotated C++ headers and writes what carries them over a wire.\n"
      "What stands behind -- goes to clang. Also: suturec diff OLD NEW, for two schema files or "
      "folders.",
      "suturec"};
  declare(app, options);
  try {
    std::reverse(split.own.begin(), split.own.end());  // CLI11 takes them from the end
    app.parse(split.own);
    if (!options.explain.empty()) return {std::nullopt, explain(options.explain)};
    if (options.listOutputs) return {std::nullopt, listOutputs()};
    if (options.headers.empty()) throw CLI::RequiredError("headers");
    if (options.outputDirectory.empty() && !options.updateLock && !options.fix) {
      throw CLI::RequiredError("--out (or --update-lock)");
    }
    if (options.lockDirectories.empty()) throw CLI::RequiredError("--lock-dir");
  } catch (const CLI::ParseError& error) {
    return {std::nullopt, app.exit(error) == 0 ? 0 : 1};
  }
  return {std::move(options), 0};
}

}  // namespace suture::compiler::driver
