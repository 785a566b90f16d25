#pragma once
// One function a rule; each appends its findings.

#include "compiler/model/diagnostic.h"
#include "compiler/model/lookup.h"
#include "compiler/model/model.h"

namespace suture::compiler::check {

/// Wire names: legal for capnp, free of what its C++ reserves, distinct where they meet.
void checkNames(const model::Header& header, model::Diagnostics& findings);

/// Enums: neither empty nor larger than the wire's 16 bits, values distinct, one fallback at most.
void checkEnums(const model::Header& header, model::Diagnostics& findings);

/// Names that was() exchanges: their lock would read the same before and after.
void checkExchanges(const model::Header& header, model::Diagnostics& findings);

/// unit() and range() of fields, parameters, results and payloads; defaults within their ranges.
void checkNumbers(const model::Header& header, model::Diagnostics& findings);

/// queue(), latest() and ttl(): where they mean something, and which exclude each other.
void checkQueues(const model::Header& header, model::Diagnostics& findings);

/// Contracts as wholes: versions, deadlines, what an annotation means for a kind of command, names
/// that generated code needs for itself.
void checkContracts(const model::Header& header, model::Diagnostics& findings);

/// since() and deprecated(): versions count from 1, and what is new avoids what is old.
void checkLifecycles(const model::Header& header, const model::Lookup& lookup,
                     model::Diagnostics& findings);

/// Contracts that say crtk(): names by its grammar, payloads by its table.
void checkCrtk(const model::Header& header, const model::Lookup& lookup,
               model::Diagnostics& findings);

/// Components: the names and annotations of their interfaces.
void checkComponents(const model::Header& header, model::Diagnostics& findings);

/// Reads of types that own heap return by const reference.
void checkReads(const model::Header& header, const model::Lookup& lookup,
                model::Diagnostics& findings);

/// What a contract carries is not too large; where a task provides or requires it, every string and
/// list is bounded, and nothing contains itself.
void checkBounds(const model::Header& header, const model::Lookup& lookup,
                 model::Diagnostics& findings);

/// Sizes and depths that no message can have.
void checkLimits(const model::Header& header, const model::Lookup& lookup,
                 model::Diagnostics& findings);

/// Appends an error; the result takes notes.
model::Diagnostic& addError(model::Diagnostics& findings, const model::Source& source,
                            std::string slug, std::string message, std::string help);

}  // namespace suture::compiler::check
