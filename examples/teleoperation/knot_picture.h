#pragma once
// The picture of a knot that was placed.

#include <filesystem>

#include "plan.h"

namespace demo {

/// Above, what both eyes of the endoscope saw at the end: a ring about what is there, a black cross
/// where it was seen, a blue line along which the knot was to come, and a white cross at the
/// target. Below, the knot's distance from its target over time: a line every second and every 5
/// mm, green within 1 mm, grey while it was not guided. Throws suture::SetupError if the plan
/// places no knot, the recording cannot be read, or the file cannot be written.
void drawKnot(const std::filesystem::path& file, const Plan& plan);

}  // namespace demo
