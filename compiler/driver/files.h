#pragma once
// Writing without disturbing: no half-written file, and none touched whose text stays.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace suture::compiler::driver {

/// None if the file cannot be read.
std::optional<std::string> readText(const std::filesystem::path& path);

/// Through a temporary file beside it and a rename. Throws std::runtime_error naming the path.
void writeText(const std::filesystem::path& path, const std::string& text);

/// False if the file had this text already and was left alone.
bool writeIfChanged(const std::filesystem::path& path, const std::string& text);

/// A Make rule: `target` depends on the files.
std::string makeRule(const std::string& target, const std::vector<std::string>& files);

}  // namespace suture::compiler::driver
