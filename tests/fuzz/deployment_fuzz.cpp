// This gives any bytes to the reader of deployment files: the result is problems that each name
// their line, or a system in which every name leads somewhere.

#include <suture/deploy/document/deployment.h>

#include <algorithm>
#include <string>

#include "tests/fuzz/require.h"

namespace {

using namespace suture;
using fuzz::require;

void requireLine(const std::string& problem, std::string_view text) {
  const std::string name = "system.json:";
  require(problem.starts_with(name));
  const std::size_t end = problem.find(": error: ");
  require(end != std::string::npos);
  const long line = std::stol(problem.substr(name.size(), end - name.size()));
  require(line >= 1 && line <= 1 + std::count(text.begin(), text.end(), '\n'));
}

void requireComponent(const Deployment& deployment, const Endpoint& endpoint) {
  const auto& components = deployment.process(endpoint.process).components;
  require(std::any_of(components.begin(), components.end(),
                      [&](const ComponentEntry& one) { return one.name == endpoint.component; }));
  require(Endpoint::parse(endpoint.toString()).toString() == endpoint.toString());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const Deployment deployment(JsonDocument::parse(text, "system.json"));
    for (const ProcessEntry& process : deployment.processes()) {
      require(&deployment.process(process.name) == &process);
    }
    for (const ConnectionEntry& connection : deployment.connections()) {
      requireComponent(deployment, connection.from);
      requireComponent(deployment, connection.to);
    }
  } catch (const DocumentError& error) {
    require(!error.problems().empty());
    for (const std::string& problem : error.problems()) requireLine(problem, text);
  }
  return 0;
}
