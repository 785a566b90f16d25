#pragma once
// These write the results of trials as a table of comma-separated values.

#include <string>

#include "experiment/result.h"
#include "experiment/trial.h"

namespace experiment {

/// Returns the names of the columns.
std::string header();
/// Returns a trial in these columns, in ms, %, mm and s. A time that a trial lacks is empty.
std::string row(const Trial& trial, const Result& result);

}  // namespace experiment
