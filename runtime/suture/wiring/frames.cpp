#include <suture/base/errors.h>
#include <suture/wiring/frames.h>

namespace suture {
namespace {

std::string difference(const char* kind, const std::string& required, const std::string& provided) {
  if (required.empty() || provided.empty() || required == provided) return "";
  return std::string(kind) + " frame '" + required + "' and is offered '" + provided + "'";
}

}  // namespace

std::string frameDifference(const Frames& required, const Frames& provided) {
  const std::string reference = difference("reference", required.reference, provided.reference);
  const std::string moving = difference("moving", required.moving, provided.moving);
  if (reference.empty() && moving.empty()) return "";
  return "expects " + reference + (reference.empty() || moving.empty() ? "" : ", and ") + moving;
}

void requireSameFrames(const Frames& required, const Frames& provided,
                       const std::string& connection) {
  const std::string difference = frameDifference(required, provided);
  if (difference.empty()) return;
  throw SetupError("connecting " + connection, "it " + difference,
                   "Connect it to an interface of its frames, or correct the frames that its "
                   "component or the deployment declares");
}

}  // namespace suture
