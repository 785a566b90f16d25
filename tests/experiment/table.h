#pragma once
// These write the results of trials as a table of comma-separated values.

#include <string>

#include "experiment/result.h"
#include "experiment/trial.h"

namespace experiment {

/// Returns the names of the columns.
std::string header();
/// Returns a trial in these columns: ms, %, mm and s. A time that is none is empty.
std::string row(const Trial& trial, const Result& result);

}  // namespace experiment
