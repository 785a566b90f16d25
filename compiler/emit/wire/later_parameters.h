#pragma once
// Tells what commands and events have got since they were first locked.

#include <set>
#include <string>

#include "compiler/emit/text/context.h"

namespace suture::compiler::emit {

/// Returns the wire names of the parameters that came later than the command, which an older client
/// does not send. It must send all others, because no arm may move to a goal that was left out.
std::set<std::string> laterParameters(const Context& context, const model::Interface& interface,
                                      const model::Command& command);

/// Returns the wire names of the values that came later than the event, which an older provider
/// does not send.
std::set<std::string> laterValues(const Context& context, const model::Interface& interface,
                                  const model::Event& event);

}  // namespace suture::compiler::emit
