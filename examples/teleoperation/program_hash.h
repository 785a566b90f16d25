#pragma once
// This says which program a process runs.

#include <filesystem>
#include <string>

namespace demo {

/// A ProgramHash is a file, and a hash that tells if two files are the same, byte by byte.
struct ProgramHash {
  std::string name;    ///< the file's name without its folder
  std::string sha256;  ///< in hexadecimal digits

  bool operator==(const ProgramHash&) const = default;
};

/// Throws suture::SetupError if the file cannot be read.
ProgramHash hashProgram(const std::filesystem::path& file);

}  // namespace demo
