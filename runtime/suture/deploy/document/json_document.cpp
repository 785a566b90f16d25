#include <suture/deploy/document/document_builder.h>
#include <suture/deploy/document/json_document.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace suture {
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

}  // namespace

DocumentError::DocumentError(std::vector<std::string> problems)
    : std::runtime_error(joined(problems)), problems_(std::move(problems)) {}

JsonDocument JsonDocument::read(const std::filesystem::path& file) {
  const bool folder = std::filesystem::is_directory(file);
  std::ifstream in(file, std::ios::binary);
  if (folder || !in) {
    const std::string found = folder ? "it is a folder" : std::strerror(errno);
    throw DocumentError({file.string() + ": error: cannot be read: " + found +
                         ". Give the path of a readable JSON file"});
  }
  return parse(std::string{std::istreambuf_iterator<char>(in), {}}, file.string());
}

JsonDocument JsonDocument::parse(std::string_view text, std::string name) {
  JsonDocument document(std::move(name));
  DocumentBuilder(document, text).build();
  return document;
}

int JsonDocument::lineOf(std::string pointer) const {
  while (true) {
    if (const auto found = lines_.find(pointer); found != lines_.end()) return found->second;
    if (pointer.empty()) return 1;
    pointer.erase(pointer.rfind('/'));
  }
}

std::filesystem::path JsonDocument::besideIt(const std::string& path) const {
  if (path.empty()) return {};
  return std::filesystem::path(name_).parent_path() / path;
}

std::string JsonDocument::locate(const std::string& pointer, std::string_view text) const {
  return place(pointer) + ": error: " + std::string(text);
}

std::string JsonDocument::warn(const std::string& pointer, std::string_view text) const {
  return place(pointer) + ": warning: " + std::string(text);
}

std::string JsonDocument::place(const std::string& pointer) const {
  return name_ + ":" + std::to_string(lineOf(pointer));
}

std::string childPointer(const std::string& pointer, std::string_view key) {
  std::string child = pointer + '/';
  for (const char c : key) {
    if (c == '~' || c == '/') {
      child += c == '~' ? "~0" : "~1";
    } else {
      child += c;
    }
  }
  return child;
}

}  // namespace suture
