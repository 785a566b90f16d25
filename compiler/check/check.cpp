#include "compiler/check/check.h"

#include <vector>

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

namespace {

/// Returns the header without what contracts inherit, which was judged where it is declared.
model::Header declaredIn(model::Header header) {
  const auto inherited = [](const auto& member) { return !member.inheritedFrom.empty(); };
  for (model::Interface& interface : header.interfaces) {
    std::erase_if(interface.commands, inherited);
    std::erase_if(interface.events, inherited);
  }
  return header;
}

}  // namespace

model::Diagnostics check(const model::Model& model) {
  const model::Lookup lookup(model);
  model::Diagnostics findings;
  for (const model::Header& complete : model.headers) {
    if (!complete.own) continue;
    checkNames(complete, model, findings);
    checkContractSizes(complete, findings);
    const model::Header header = declaredIn(complete);
    checkHiddenNames(header, findings);
    checkEnums(header, findings);
    checkExchanges(header, findings);
    checkNumbers(header, findings);
    checkInitialisers(header, lookup, findings);
    checkQueues(header, findings);
    checkContracts(header, lookup, findings);
    checkLifecycles(header, lookup, findings);
    checkCrtk(header, lookup, findings);
    checkComponents(header, findings);
    checkLimits(header, lookup, findings);
    checkReads(header, lookup, findings);
    checkBounds(header, lookup, findings);
  }
  checkGeneratedNames(model, lookup, findings);
  return findings;
}

}  // namespace suture::compiler::check
