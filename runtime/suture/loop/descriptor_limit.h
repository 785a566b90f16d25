#pragma once
// This lets a program have as many descriptors as its user may.

namespace suture::loop {

/// Call it in main(). Raises the soft limit of descriptors to the hard one. Components, connections
/// and peers take descriptors, and the usual soft limit is 1024. It is that low for programs that
/// use select(): a program that does must not call this.
void allowAllDescriptors();

}  // namespace suture::loop
