#pragma once
// This is the picture of a knot that was placed.

#include <filesystem>
#include <optional>

#include "picture/process_graph.h"
#include "run/break.h"
#include "run/plan.h"

namespace demo {

/// Returns the knot that a picture can show. Throws suture::SetupError if the plan places none,
/// which is known before the run.
const KnotPlacing& requireKnot(const Plan& plan);

/// Draws above the scene at the end for both eyes of the endoscope. It is painted anew from the
/// true strand of the recording's last row and without noise, because images are not recorded: a
/// ring is about what is there, a black cross where it was seen, the corridor in blue, and a white
/// cross at the target. Marks that are not before the camera are left out; if a part of the strand
/// is not, the view is blank. Below that is the knot's distance from its target over time: green
/// within 1 mm, grey while it was not guided, red while a process was cut off. Below that are the
/// processes and the ages of what went between them. Throws suture::SetupError if the recording
/// cannot be read or has no row, or if the file cannot be written.
void drawKnot(const std::filesystem::path& file, const KnotPlacing& placing,
              const ProcessGraph& graph, const std::optional<Outage>& outage);

}  // namespace demo
