#pragma once
// This is a JSON text that remembers the place of each of its values.

#include <suture/component/factory/json_reader.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// Says everything that is wrong with a document: each problem as "file:line: error: what was
/// found; what to do". The place says what was asked.
class DocumentError : public std::runtime_error {
 public:
  explicit DocumentError(std::vector<std::string> problems);

  const std::vector<std::string>& problems() const { return problems_; }

 private:
  std::vector<std::string> problems_;
};

/// Set-up code only. Values are named by RFC 6901 pointers: "/processes/0/name".
class JsonDocument {
 public:
  /// Throws DocumentError if the file cannot be read or is not JSON. A key that appears twice in an
  /// object is an error too, because one of the two would silently be ignored.
  static JsonDocument read(const std::filesystem::path& file);
  /// Does the same for a text; `name` stands for the file in messages.
  static JsonDocument parse(std::string_view text, std::string name);

  const nlohmann::json& value() const { return value_; }
  const std::string& name() const { return name_; }
  /// Returns `path`, which a file means relative to its folder; "" for "".
  std::filesystem::path besideIt(const std::string& path) const;

  /// Returns the line, from 1, of the value at `pointer` (of its key, if it has one), or of the
  /// closest one around it.
  int lineOf(std::string pointer) const;
  /// Returns "file:line: error: text".
  std::string locate(const std::string& pointer, std::string_view text) const;
  /// Returns "file:line: warning: text".
  std::string warn(const std::string& pointer, std::string_view text) const;

 private:
  friend class DocumentBuilder;

  std::string place(const std::string& pointer) const;

  explicit JsonDocument(std::string name) : name_(std::move(name)) {}

  std::string name_;
  nlohmann::json value_;
  std::map<std::string, int> lines_;
};

/// Returns `pointer` with one more step; escapes '~' and '/' in the key.
std::string childPointer(const std::string& pointer, std::string_view key);

}  // namespace suture
