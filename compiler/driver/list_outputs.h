#pragma once
// This is `suturec --list-outputs`.

namespace suture::compiler::driver {

/// Prints a line for each file that a header gives: what a build does with it, and its ending.
/// Returns the exit status.
int listOutputs();

}  // namespace suture::compiler::driver
