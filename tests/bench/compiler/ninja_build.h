#pragma once
// This is a project built with Ninja, and what ran in each build.

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace bench {

class NinjaBuild {
 public:
  /// Configures the project in `source` below `build`, with `settings` as for cmake -D. Throws
  /// SetupError.
  NinjaBuild(std::filesystem::path source, std::filesystem::path build,
             const std::map<std::string, std::string>& settings);

  struct Ran {
    std::size_t generators = 0;     ///< runs of suturec
    std::size_t schemas = 0;        ///< runs of capnp
    std::set<std::string> objects;  ///< compiled ones
    std::size_t rewritten = 0;      ///< generated files with a new time
  };
  /// Builds `target`, or everything if it is "".
  Ran build(const std::string& target = "");

  /// Returns the objects that include a file whose path ends so, as the compiler said.
  std::set<std::string> including(const std::set<std::string>& endings) const;

 private:
  std::set<std::string> finishedSince(std::uintmax_t logSize) const;
  std::uintmax_t logSize() const;
  std::map<std::filesystem::path, std::filesystem::file_time_type> generatedTimes() const;

  std::filesystem::path source_, build_;
};

}  // namespace bench
