#pragma once
// How many threads drawing and seeing take.

namespace robots {

/// Mesa and OpenCV start as many threads as there are processors, unless they are told otherwise
/// before they work for the first time: from now on both work in the thread that asks, and Mesa
/// keeps nothing in files. For the whole process, and for the thread that sets a system up, since
/// Mesa is told by the environment, which has no lock.
void workInOneThread();

}  // namespace robots
