#pragma once
// These are the three parts into which the paper takes the overhead apart.

#include <string>

#include "bench/figures/report.h"
#include "bench/table2/codec.h"

namespace bench {

/// Adds the figures "codec.encode", "codec.create", "codec.decode", "codec.sum" and "execution",
/// ns.
void addOverhead(const CodecCost& codec, const Statistics& execution, Report& report);

/// Leaves "overhead.scs.transmission" and its like, us, made of the event-driven differences that
/// the report has already. Returns the tables.
std::string overheadRows(const CodecCost& codec, const Statistics& execution, Report& report);

}  // namespace bench
