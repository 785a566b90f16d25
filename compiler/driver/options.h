#pragma once
// This reads the command line of suturec.

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace suture::compiler::driver {

struct Options {
  std::vector<std::string> headers;  ///< as written
  std::string targetName = "headers";
  std::string baseDirectory = ".";
  std::string outputDirectory;
  std::map<std::string, unsigned> sources;  ///< how many of each kind, by the path of a big header
  std::vector<std::string>
      lockDirectories;            ///< the first is the target's own, and written by --update-lock
  std::string depfile, stamp;     ///< "" = none
  std::string componentsFile;     ///< where the entry point goes, below outputDirectory; "" = none
  std::string resourceDirectory;  ///< "" = look for it
  std::string project = "suture";
  std::string lockCommand = "suturec --update-lock";
  std::string breakCommand = "suturec --update-lock --accept-break";
  bool updateLock = false;
  bool acceptBreak = false;
  std::vector<std::string> newIds;         ///< names that get a new id, with updateLock
  std::string explain;                     ///< the slug to explain; "" = none
  bool listOutputs = false;                ///< print the endings of generated files, and end
  bool fix = false;                        ///< apply fix-its instead of generating
  std::vector<std::string> fatalWarnings;  ///< slugs, or "all"
  std::vector<std::string> clangArguments;
};

/// Says what to do with a command line: run with the options, or end with the exit status at once
/// (the usage or an error has been printed).
struct Parsed {
  std::optional<Options> options;
  int exitStatus = 0;
};

/// Takes the arguments without the program's name. An "@file" among them stands for the lines of
/// that file.
Parsed parseOptions(const std::vector<std::string>& arguments);

}  // namespace suture::compiler::driver
