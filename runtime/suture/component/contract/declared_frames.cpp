#include <suture/base/errors.h>
#include <suture/component/contract/declared_frames.h>

namespace suture {
namespace {

void add(std::string& known, const std::string& named, const char* kind,
         const std::string& interface) {
  if (named.empty() || named == known) return;
  if (!known.empty()) {
    throw SetupError("declaring '" + named + "' as the " + kind + " frame of '" + interface + "'",
                     "that is '" + known + "' already", "Declare each frame once");
  }
  known = named;
}

}  // namespace

void DeclaredFrames::add(const Frames& frames, const std::string& interface) {
  suture::add(frames_.reference, frames.reference, "reference", interface);
  suture::add(frames_.moving, frames.moving, "moving", interface);
}

}  // namespace suture
