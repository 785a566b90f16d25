#pragma once

#include <string>

namespace bench {

/// Says on a terminal's standard error what is being measured, over the line before; nowhere else.
/// "" clears it.
void progress(const std::string& what);

}  // namespace bench
