#include "cli/command_line/target.h"
#include "cli/command_line/options.h"

#include <string>

namespace suture::cli {
namespace {

[[noreturn]] void refuse(std::string_view text, const char* form) {
  throw UsageError("'" + std::string(text) + "'", std::string("it is not of the form ") + form,
                   "`suture ps` shows the names");
}

/// Cuts what stands before `separator` off `rest` and returns it; all of it if there is none.
std::string take(std::string_view& rest, char separator) {
  const auto end = rest.find(separator);
  std::string taken(rest.substr(0, end));
  rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
  return taken;
}

}  // namespace

Target Target::parse(std::string_view text) {
  std::string_view rest = text;
  Target target;
  target.process = take(rest, ':');
  target.component = take(rest, '/');
  target.interface = rest;
  const bool separated = target.process.find('/') == std::string::npos &&
                         target.component.find(':') == std::string::npos &&
                         target.interface.find_first_of(":/") == std::string::npos;
  if (!separated || target.process.empty() || target.toString() != text) {
    refuse(text, "process, process:component or process:component/interface");
  }
  return target;
}

Target Target::parseInterface(std::string_view text) {
  Target target = parse(text);
  if (target.interface.empty()) refuse(text, "process:component/interface");
  return target;
}

std::string Target::toString() const {
  std::string text = process;
  if (!component.empty()) text += ":" + component;
  if (!interface.empty()) text += "/" + interface;
  return text;
}

}  // namespace suture::cli
