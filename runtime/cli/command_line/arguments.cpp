#include "cli/command_line/arguments.h"
#include <suture/deploy/document/json_document.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

namespace suture::cli {
namespace {

/// Returns the JSON that `text` is, or none; `name` stands for it in messages. A key that is given
/// twice is refused, because one of the two would silently be ignored.
std::optional<Json> parsed(const std::string& text, const std::string& name) {
  if (!Json::accept(text)) return std::nullopt;
  try {
    JsonDocument::parse(text, name);
  } catch (const DocumentError& error) {
    throw UsageError(error.what());
  }
  return Json::parse(text);
}

/// Returns "/goal/pose/x" for "goal.pose.x".
std::string pointerOf(const std::string& name) {
  std::string pointer = "/" + name;
  std::replace(pointer.begin(), pointer.end(), '.', '/');
  return pointer;
}

/// Tells if one pointer leads to what the other does, or into it.
bool overlap(const std::string& one, const std::string& other) {
  return (one + "/").starts_with(other + "/") || (other + "/").starts_with(one + "/");
}

/// Tells if a part of a pointer is a number of more than six digits. A list would have to grow that
/// long first, which may take more memory than there is.
bool leadsTooFar(const std::string& pointer) {
  std::size_t digits = 0;
  for (const char one : pointer) {
    digits = std::isdigit(static_cast<unsigned char>(one)) != 0 ? digits + 1 : 0;
    if (digits > 6) return true;
  }
  return false;
}

/// Collects settings.
class Settings {
 public:
  explicit Settings(Json& arguments) : arguments_(arguments) {}

  void add(const std::string& setting) {
    const auto equals = setting.find('=');
    const std::string asked = "argument '" + setting + "'";
    if (equals == std::string::npos || equals == 0) {
      throw UsageError(asked, "it has no name",
                       "Write name=value, or all of them as --args '{\"name\": value}'");
    }
    const std::string name = setting.substr(0, equals), text = setting.substr(equals + 1);
    const std::string pointer = claim(name, asked);
    try {
      arguments_[Json::json_pointer(pointer)] =
          parsed(text, "argument '" + name + "'").value_or(Json(text));
    } catch (const Json::exception&) {
      throw UsageError(asked, "what it is part of has a value already", "Give that once");
    }
  }

 private:
  std::string claim(const std::string& name, const std::string& asked) {
    const std::string pointer = pointerOf(name);
    if (leadsTooFar(pointer)) {
      throw UsageError(asked, "no list has so many elements", "Give all of it in --args");
    }
    for (const std::string& other : given_) {
      if (!overlap(pointer, other)) continue;
      throw UsageError(asked, "it, or a part of it, is given already", "Give it once");
    }
    given_.push_back(pointer);
    return pointer;
  }

  Json& arguments_;
  std::vector<std::string> given_;
};

}  // namespace

Json argumentsOf(const Options& options) {
  Json arguments = Json::object();
  if (!options.arguments.empty()) {
    arguments = parsed(options.arguments, "--args").value_or(Json());
    if (!arguments.is_object()) {
      throw UsageError("--args " + options.arguments, "it is not a JSON object",
                       "Write --args '{\"name\": value}'");
    }
  }
  Settings settings(arguments);
  for (const std::string& setting : options.settings) settings.add(setting);
  return arguments;
}

void takeTexts(Json& arguments, const Options& options, const IsText& isText) {
  for (const std::string& setting : options.settings) {
    const auto equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    const Json::json_pointer pointer(pointerOf(name));
    if (!arguments.contains(pointer)) continue;  // "names.-=x" has added an element
    Json& value = arguments.at(pointer);
    if (value.is_string() || !isText(name, value)) continue;
    value = setting.substr(equals + 1);
  }
}

}  // namespace suture::cli
