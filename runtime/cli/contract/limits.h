#pragma once
// These are the limits that a contract declares of the arguments of its commands.

#include <suture/base/errors.h>
#include "cli/contract/contract.h"
#include "cli/values/json.h"

#include <string>

namespace suture::cli {

/// Returns the first of the arguments that is beyond a limit, and the limit: "'tolerance' is 2, and
/// declared as Float64, 0 to 1"; "" if none is. Errc::Invalid is about ranges, Errc::TooLarge about
/// capacities; no other error is about limits.
std::string beyondLimit(const Contract& contract, const Member& command, const Json& arguments,
                        Errc error);

}  // namespace suture::cli
