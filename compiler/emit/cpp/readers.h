#pragma once
// These emit JSON readers of component parameters, and the classes that a deployment creates
// components by.
//
// A parameters struct declared in the same header as its component has its fromJson() declared in
// the generated header. What else parameters are made of is read by the source of its own header,
// for all sources of the target; if that header is another target's, by an inline fromJson() in
// each source that needs it, equal everywhere.

#include <set>
#include <string>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Tells if the header declares a component's parameters.
bool hasReaders(const model::Header& header);

/// Tells if its source reads what parameters of components in other headers consist of.
bool readsForOthers(const Context& context);

/// Returns the namespaces of those readers: the header's own, and those of foreign types that it
/// lists.
std::set<std::string> readerNamespaces(const Context& context);

/// Declares those readers in namespace `home`, for the generated header.
void emitReaderDeclarations(Code& code, const Context& context, const std::string& home);

/// Defines the readers of everything that the header's components are configured with.
void emitReaders(Code& code, const Context& context);

/// Declares componentClass<T>() of each component, for the generated header.
void emitClassDeclarations(Code& code, const Context& context);

/// Defines those functions.
void emitClasses(Code& code, const Context& context);

}  // namespace suture::compiler::emit
