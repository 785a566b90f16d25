#pragma once
// Each rule is one function, which appends its findings.

#include "compiler/model/diagnostic.h"
#include "compiler/model/lookup.h"
#include "compiler/model/model.h"

namespace suture::compiler::check {

/// Checks that wire names are legal for capnp, free of what its C++ reserves, and distinct where
/// they meet.
void checkNames(const model::Header& header, const model::Model& model,
                model::Diagnostics& findings);

/// Checks that generated code can reach the types that a header names, and the runtime: it names
/// them from their outermost namespace on.
void checkHiddenNames(const model::Header& header, model::Diagnostics& findings);

/// Checks that no two commands or events give generated code one name.
void checkGeneratedNames(const model::Model& model, const model::Lookup& lookup,
                         model::Diagnostics& findings);

/// Checks that enums are neither empty nor larger than the wire's 16 bits, that their values are
/// distinct, and that one at most is the fallback.
void checkEnums(const model::Header& header, model::Diagnostics& findings);

/// Refuses names that was() exchanges, because their lock would read the same before and after.
void checkExchanges(const model::Header& header, model::Diagnostics& findings);

/// Checks unit() and range() of fields, parameters, results and payloads, and that defaults lie
/// within their ranges.
void checkNumbers(const model::Header& header, model::Diagnostics& findings);

/// Warns of fields that nothing initialises: what their memory held would be sent. Fields of
/// structs that cannot be edited are told at the fields that have such a struct.
void checkInitialisers(const model::Header& header, const model::Lookup& lookup,
                       model::Diagnostics& findings);

/// Checks that queue(), latest() and ttl() stand where they mean something, and that none excludes
/// another.
void checkQueues(const model::Header& header, model::Diagnostics& findings);

/// Checks contracts as wholes: their versions and deadlines, what an annotation means for a kind of
/// command, and names that generated code needs for itself.
void checkContracts(const model::Header& header, const model::Lookup& lookup,
                    model::Diagnostics& findings);

/// Checks that no contract has more reads or events than a connection can tell apart, with what it
/// inherits.
void checkContractSizes(const model::Header& header, model::Diagnostics& findings);

/// Checks since() and deprecated(): versions count from 1, and what is new avoids what is old.
void checkLifecycles(const model::Header& header, const model::Lookup& lookup,
                     model::Diagnostics& findings);

/// Checks contracts that say crtk(): their names by CRTK's grammar, their payloads by its table.
void checkCrtk(const model::Header& header, const model::Lookup& lookup,
               model::Diagnostics& findings);

/// Checks the names and annotations of components' interfaces.
void checkComponents(const model::Header& header, model::Diagnostics& findings);

/// Checks that reads of types that own heap return by const reference.
void checkReads(const model::Header& header, const model::Lookup& lookup,
                model::Diagnostics& findings);

/// Checks that what a contract carries is not too large. If a task provides or requires it, every
/// string and list must have a bound, and nothing may contain itself.
void checkBounds(const model::Header& header, const model::Lookup& lookup,
                 model::Diagnostics& findings);

/// Refuses sizes and depths that no message can have.
void checkLimits(const model::Header& header, const model::Lookup& lookup,
                 model::Diagnostics& findings);

/// Appends an error, and returns it so that the caller can add notes.
model::Diagnostic& addError(model::Diagnostics& findings, const model::Source& source,
                            std::string slug, std::string message, std::string help);

}  // namespace suture::compiler::check
