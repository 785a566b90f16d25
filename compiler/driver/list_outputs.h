#pragma once
// This is `suturec --list-outputs`.

namespace suture::compiler::driver {

/// Prints a line for each file that suturec writes for a header: what a build does with the file,
/// and how its name ends. Returns the exit status.
int listOutputs();

}  // namespace suture::compiler::driver
