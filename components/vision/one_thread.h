#pragma once
// This says how many threads drawing and seeing use.

namespace robots {

/// Call this in the thread that sets a system up, because it changes the environment, which has no
/// lock; it holds for the whole process. Mesa and OpenCV start as many threads as there are
/// processors, unless they are told otherwise before they work for the first time. From this call
/// on both work in the thread that calls them, and Mesa keeps nothing in files.
void workInOneThread();

}  // namespace robots
