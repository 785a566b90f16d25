#include "cli/command_line/arguments.h"

#include <algorithm>

namespace suture::cli {
namespace {

Json parsed(const std::string& text) {
  return Json::parse(text, nullptr, /*allow_exceptions=*/false);
}

void set(Json& arguments, const std::string& setting) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("argument '" + setting + "'", "it has no name",
                     "Write name=value, or all of them as --args '{\"name\": value}'");
  }
  std::string path = "/" + setting.substr(0, equals);
  std::replace(path.begin(), path.end(), '.', '/');
  const std::string text = setting.substr(equals + 1);
  Json value = parsed(text);
  try {
    arguments[Json::json_pointer(path)] = value.is_discarded() ? Json(text) : std::move(value);
  } catch (const Json::exception&) {
    throw UsageError("argument '" + setting + "'", "what it is part of has a value already",
                     "Give that once");
  }
}

}  // namespace

Json argumentsOf(const Options& options) {
  Json arguments = Json::object();
  if (!options.arguments.empty()) {
    arguments = parsed(options.arguments);
    if (!arguments.is_object()) {
      throw UsageError("--args " + options.arguments, "it is not a JSON object",
                       "Write --args '{\"name\": value}'");
    }
  }
  for (const std::string& setting : options.settings) set(arguments, setting);
  return arguments;
}

}  // namespace suture::cli
