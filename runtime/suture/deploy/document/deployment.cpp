#include <suture/base/nearest.h>
#include <suture/deploy/document/consistency.h>
#include <suture/deploy/document/deployment.h>
#include <suture/deploy/document/deployment_reader.h>
#include <suture/deploy/document/entry_names.h>
#include <suture/deploy/document/schema_check.h>

namespace suture {

Deployment::Deployment(JsonDocument document) : document_(std::move(document)) {
  if (const auto problems = read(); !problems.empty()) throw DocumentError(problems);
}

Deployment::Deployment(JsonDocument document, std::vector<std::string>& problems)
    : document_(std::move(document)) {
  const auto found = read();
  problems.insert(problems.end(), found.begin(), found.end());
}

std::vector<std::string> Deployment::read() {
  requireSchema(document_, deploymentSchema());
  DocumentProblems problems(document_);
  DeploymentReader reader(document_, problems);
  manager_ = reader.manager();
  processes_ = reader.processes();
  connections_ = reader.connections();
  checkConsistency(*this, problems);
  return problems.found();
}

const ProcessEntry& Deployment::process(std::string_view name) const {
  if (const ProcessEntry* process = findNamed(processes_, name)) return *process;
  const auto names = namesOf(processes_);
  throw DocumentError(
      {document_.locate("/processes", "no process '" + std::string(name) + "' here; there are " +
                                          listNames(names) + suggestion(name, names))});
}

}  // namespace suture
