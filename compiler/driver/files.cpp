#include "compiler/driver/files.h"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace suture::compiler::driver {
namespace {

namespace fs = std::filesystem;

std::string escaped(const std::string& path) {
  std::string result;
  for (const char c : path) {
    if (c == ' ' || c == '#') result += '\\';
    if (c == '$') result += '$';
    result += c;
  }
  return result;
}

[[noreturn]] void cannotWrite(const fs::path& path, const std::error_code& why) {
  throw std::runtime_error("cannot write '" + path.string() + "': " + why.message());
}

}  // namespace

std::optional<std::string> readText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || !fs::is_regular_file(path)) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

NewFiles::~NewFiles() {
  std::error_code ignored;
  for (const File& file : files_) fs::remove(file.temporary, ignored);
}

void NewFiles::add(const fs::path& path, const std::string& text) {
  std::error_code failed;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), failed);
  files_.push_back({path.string() + ".tmp" + std::to_string(::getpid()), path});
  errno = 0;
  std::ofstream file(files_.back().temporary, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  // A folder is refused here, since place() would find it only after other files are in place.
  if (fs::is_directory(path)) cannotWrite(path, std::make_error_code(std::errc::is_a_directory));
  if (!file) cannotWrite(path, failed ? failed : std::error_code(errno, std::generic_category()));
}

bool NewFiles::addIfChanged(const fs::path& path, const std::string& text) {
  if (readText(path) == text) return false;
  add(path, text);
  return true;
}

void NewFiles::place() {
  for (const File& file : files_) {
    std::error_code failed;
    fs::rename(file.temporary, file.path, failed);
    if (failed) cannotWrite(file.path, failed);
  }
  files_.clear();
}

void writeText(const fs::path& path, const std::string& text) {
  NewFiles file;
  file.add(path, text);
  file.place();
}

std::string makeRule(const std::string& target, const std::vector<std::string>& files) {
  std::string rule = escaped(target) + ":";
  for (const std::string& file : files) rule += " \\\n  " + escaped(file);
  return rule + "\n";
}

}  // namespace suture::compiler::driver
