#pragma once
// This keeps the standard streams of a program apart from what it opens later.

#include <suture/base/errors.h>

#include <string>

namespace suture::loop {

/// Call it in main() before anything is opened. The first socket would have the number of a
/// standard descriptor that is closed, and what the program says would go to its peer. Such a
/// descriptor is opened here so that it takes and gives nothing: writing to it fails as before.
void openStandardDescriptors();

/// Returns that standard output does not take what is written, for the reason in errno.
SetupError outputLost();

/// Writes to standard output at once. Returns false if nobody reads it any more, which needs
/// SIGPIPE to be ignored. Throws SetupError if the text is lost otherwise.
bool writeOut(const std::string& text);

}  // namespace suture::loop
