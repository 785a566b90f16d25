#pragma once
// A contract over Cap'n Proto RPC.

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// The provider's side: the sink that sends events and rows, the servant that receives commands.
void emitServant(Code& code, const Context& context, const model::Interface& interface);

/// The client's side: the receiver of events and rows, the proxy that sends commands.
void emitProxy(Code& code, const Context& context, const model::Interface& interface);

/// The factory of both.
void emitBinding(Code& code, const Context& context, const model::Interface& interface);

/// "armBinding": the function that hands out the factory.
std::string bindingFunction(const model::Interface& interface);

}  // namespace suture::compiler::emit
