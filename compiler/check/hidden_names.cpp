#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>
#include <string_view>

#include "compiler/check/rules.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

/// Generated code specialises the runtime's templates inside namespace suture, where these inner
/// namespaces of the runtime and of its schemas hide a user's of the same name.
constexpr std::array<std::string_view, 14> kOfRuntime{
    "bounded", "codec", "detail", "dsl", "frame",          "framing", "loop",
    "net",     "rpc",   "rt",     "shm", "testing_detail", "tls",     "wire"};

bool isInName(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Returns what the qualified names of a text begin with: "std" and "msgs" of
/// "std::optional<msgs::Pose>".
std::set<std::string> rootsOf(const std::string& text) {
  std::set<std::string> roots;
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    if (!isInName(text[begin])) continue;
    std::size_t end = begin;
    while (end < text.size() && isInName(text[end])) ++end;
    const bool isRoot = begin == 0 || text[begin - 1] != ':';
    if (isRoot && text.compare(end, 2, "::") == 0) roots.insert(text.substr(begin, end - begin));
    begin = end;
  }
  return roots;
}

/// Knows which names the code generated for a header cannot reach.
class Hidden {
 public:
  Hidden(const model::Header& header, model::Diagnostics& findings)
      : home_(header.cxxNamespace), findings_(findings) {
    std::size_t begin = home_.find("::");
    while (begin != std::string::npos) {
      const std::size_t end = home_.find("::", begin + 2);
      inner_.insert(home_.substr(begin + 2, end == std::string::npos ? end : end - begin - 2));
      begin = end;
    }
  }

  void checkHome(const model::Source& source) const {
    const std::string root = home_.substr(0, home_.find("::"));
    if (inner_.contains("suture")) {
      report(source, "namespace '" + home_ + "' hides the runtime's namespace 'suture'");
    }
    if (std::find(kOfRuntime.begin(), kOfRuntime.end(), root) != kOfRuntime.end()) {
      report(source, "namespace '" + root + "' is hidden by 'suture::" + root + "'");
    }
  }

  void check(const std::string& spelling, const model::Source& source) const {
    const bool isOwn = spelling.starts_with(home_ + "::");
    const std::size_t begin = isOwn ? home_.size() + 2 : 0;
    for (const std::string& root : rootsOf(spelling.substr(begin))) {
      if (!inner_.contains(root)) continue;
      return report(source, "namespace '" + home_ + "' hides the namespace '" + root + "' of '" +
                                spelling + "'");
    }
  }

 private:
  void report(const model::Source& source, const std::string& message) const {
    addError(findings_, source, "hidden-namespace", message + " from generated code",
             "call the namespace otherwise");
  }

  std::string home_;
  std::set<std::string> inner_;  // the parts of `home_` but the first
  model::Diagnostics& findings_;
};

}  // namespace

void checkHiddenNames(const model::Header& header, model::Diagnostics& findings) {
  const Hidden hidden(header, findings);
  if (!header.structs.empty()) {
    hidden.checkHome(header.structs.front().source);
  } else if (!header.interfaces.empty()) {
    hidden.checkHome(header.interfaces.front().source);
  } else if (!header.components.empty()) {
    hidden.checkHome(header.components.front().source);
  }
  for (const model::Enum& one : header.enums) hidden.check(one.name, one.source);
  for (const model::Struct& one : header.structs) {
    hidden.check(one.name, one.source);
    for (const model::Field& field : one.fields) hidden.check(field.type.spelling, field.source);
  }
  for (const model::Interface& one : header.interfaces) {
    for (const model::Command& command : one.commands) {
      for (const model::Parameter& each : command.parameters)
        hidden.check(each.type.spelling, each.source);
      if (command.result) hidden.check(command.result->spelling, command.source);
    }
    for (const model::Event& event : one.events) {
      for (const model::Type& type : event.payload) hidden.check(type.spelling, event.source);
    }
  }
}

}  // namespace suture::compiler::check
