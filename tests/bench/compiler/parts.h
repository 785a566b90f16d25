#pragma once
// These are the four parts of `suture-bench compiler`: each measures, leaves its figures in the
// report and returns its table. The report says what cannot be had; it is not thrown.

#include <string>

#include "bench/compiler/options.h"
#include "bench/figures/report.h"

namespace bench {

/// Measures suturec itself beside an empty libTooling consumer and clang++ -fsyntax-only.
std::string toolRows(const CompilerOptions& options, Report& report);
/// Measures what runs again after which edit.
std::string rebuildRows(const CompilerOptions& options, Report& report);
/// Measures generated conversions beside hand-written ones and Fast CDR.
std::string codecRows(const CompilerOptions& options, Report& report);
/// Measures how long the compiler takes for generated code, beside hand-written code.
std::string compileRows(const CompilerOptions& options, Report& report);

}  // namespace bench
