#include "compiler/check/check.h"

#include "compiler/check/rules.h"

namespace suture::compiler::check {

model::Diagnostic& addError(model::Diagnostics& findings, const model::Source& source,
                            std::string slug, std::string message, std::string help) {
  model::Diagnostic finding;
  finding.source = source;
  finding.slug = std::move(slug);
  finding.message = std::move(message);
  finding.help = std::move(help);
  return findings.emplace_back(std::move(finding));
}

model::Diagnostics check(const model::Model& model) {
  const model::Lookup lookup(model);
  model::Diagnostics findings;
  checkRecursion(model, lookup, findings);
  const bool finite = findings.empty();
  for (const model::Header& header : model.headers) {
    if (!header.own) continue;
    checkNames(header, findings);
    checkEnums(header, findings);
    checkNumbers(header, findings);
    checkQueues(header, findings);
    if (!finite) continue;  // the others walk through types to their end
    checkLimits(header, lookup, findings);
    checkReads(header, lookup, findings);
    checkBounds(header, lookup, findings);
  }
  return findings;
}

}  // namespace suture::compiler::check
