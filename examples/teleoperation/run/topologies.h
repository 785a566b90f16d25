#pragma once
// These are the topologies that a user may choose from. They are deployment files, and nothing
// else.

#include <filesystem>
#include <string>
#include <vector>

namespace demo {

/// These are the deployment files of one folder, a value for set-up code only.
class Topologies {
 public:
  /// Returns those that lie where the build and the installation put them for a program in that
  /// folder.
  static Topologies besideProgramsIn(const std::filesystem::path& programs);

  explicit Topologies(std::filesystem::path folder);

  /// Returns the file of a name in the folder; a text that ends with ".json" is a file itself.
  /// Throws suture::SetupError with the possible names if there is no such file.
  std::filesystem::path find(const std::string& asked) const;
  /// Returns a line for each: its name, and the title that its file has.
  std::string list() const;

 private:
  const std::filesystem::path folder_;
  std::vector<std::string> names_;
};

}  // namespace demo
