#pragma once
// The four parts of `suture-bench compiler`: each measures, leaves its figures in the report and
// returns its table. What cannot be had is said in the report, not thrown.

#include <string>

#include "bench/compiler/options.h"
#include "bench/figures/report.h"

namespace bench {

/// suturec itself beside an empty libTooling consumer and clang++ -fsyntax-only.
std::string toolRows(const CompilerOptions& options, Report& report);
/// What runs again after which edit.
std::string rebuildRows(const CompilerOptions& options, Report& report);
/// Generated conversions beside hand-written ones and Fast CDR.
std::string codecRows(const CompilerOptions& options, Report& report);
/// How long the compiler takes for generated code, beside hand-written code.
std::string compileRows(const CompilerOptions& options, Report& report);

}  // namespace bench
