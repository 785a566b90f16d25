#include "run/break.h"

#include <suture/base/errors.h>
#include <suture/base/nearest.h>

#include <algorithm>
#include <vector>

namespace demo {
namespace {

/// Throws suture::SetupError if the topology has no such process.
void requireProcess(const std::string& asked, const std::string& process, const Plan& plan) {
  std::vector<std::string> names;
  for (const suture::ProcessEntry& one : plan.deployment().processes()) names.push_back(one.name);
  if (std::find(names.begin(), names.end(), process) != names.end()) return;
  throw suture::SetupError(
      asked, "topology '" + plan.name() + "' has processes " + suture::listNames(names),
      "Name one of them, or choose by --topology one that has '" + process + "'");
}

}  // namespace

std::optional<Break> parseBreak(const std::string& text, const Plan& plan, const Network& network,
                                suture::Duration runLength) {
  if (text.empty()) return std::nullopt;
  const std::string asked = "--break " + text;
  const std::size_t separator = text.find('@');
  const std::string process = text.substr(0, separator);
  const auto moment = separator == std::string::npos || process.empty()
                          ? std::nullopt
                          : parseMoment(text.substr(separator + 1));
  if (!moment) {
    throw suture::SetupError(asked, "that names no process and moment",
                             "Write for example vision@4s, or vision@4s+1500ms");
  }
  requireProcess(asked, process, plan);
  if (!plan.needsManager()) {
    throw suture::SetupError(asked, "it is the only process, and talks to no other",
                             "Choose a topology of several processes, or leave --break out");
  }
  requireRoom(asked, *moment, runLength);
  return Break{process, *moment, plan.slavesThatDependOn({process, !network.hasNamespaces()})};
}

}  // namespace demo
