#pragma once
// The topologies that a user may choose from: deployment files, and nothing else.

#include <filesystem>
#include <string>
#include <vector>

namespace demo {

/// The deployment files of one folder. A value; set-up code only.
class Topologies {
 public:
  /// Those that lie where the build, and the installation, put them for a program in that folder.
  static Topologies besideProgramsIn(const std::filesystem::path& programs);

  explicit Topologies(std::filesystem::path folder);

  /// Finds the file of a name in the folder; a text that ends with ".json" is a file itself.
  /// Throws suture::SetupError with what there is if there is no such file.
  std::filesystem::path find(const std::string& asked) const;
  /// A line for each: its name, and the title that its file has.
  std::string list() const;

 private:
  const std::filesystem::path folder_;
  std::vector<std::string> names_;
};

}  // namespace demo
