#pragma once
// This judges a whole deployment file before any of it runs.

#include <suture/component/factory/component_class.h>
#include <suture/lane/added_lanes.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace suture {

/// A Checked is what a check has found.
struct Checked {
  std::vector<std::string> problems;  ///< "file:line: error: ...", each with what to do
  std::vector<std::string> warnings;  ///< "file:line: warning: ..."
  std::string subject;                ///< what was judged: "2 processes, 5 components and ..."
};

/// Set-up code only. Judges every process of a deployment file, or only that of the name `process`
/// if it is not "", as the start of each would. Each connection between two of them is judged too:
/// its contracts, its frames and its lane. Components are created from `classes`, and from the
/// libraries that the file names, and destroyed again. Nothing is configured, started, connected or
/// asked of the machine's scheduler.
Checked checkDeployment(const std::filesystem::path& file, const std::string& process,
                        std::span<const ComponentClass> classes, const AddedLanes& added = {});

}  // namespace suture
