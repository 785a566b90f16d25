// This is an ordinary Cap'n Proto program: plain_client <address of a process>. It moves its
// PSM/Arm, reads it, hears its events, and asks for nonsense. It prints what it got, one fact a
// line.

#include <capnp/ez-rpc.h>
#include <suture/peer.capnp.h>

#include <cmath>
#include <cstdio>

#include "reference/arm_like.capnp.h"

namespace {

using reference::wire::ArmLike;
using reference::wire::ArmLikeEvents;

class Listener final : public ArmLikeEvents::Server {
 public:
  explicit Listener(kj::Own<kj::PromiseFulfiller<void>> stopped) : stopped_(kj::mv(stopped)) {}

 protected:
  kj::Promise<void> stopped(StoppedContext) override {
    stopped_->fulfill();
    return kj::READY_NOW;
  }

 private:
  kj::Own<kj::PromiseFulfiller<void>> stopped_;
};

void setPose(reference::wire::PoseStamped::Builder pose, double x) {
  auto transform = pose.initPose();
  transform.setM00(1);
  transform.setM11(1);
  transform.setM22(1);
  transform.setX(x);
  pose.setValid(true);
}

template <class Call>
void printError(const char* what, kj::WaitScope& scope, Call call) {
  try {
    call().wait(scope);
    std::printf("%s: accepted\n", what);
  } catch (const kj::Exception& e) {
    std::printf("%s: %s\n", what, e.getDescription().cStr());
  }
}

void talk(ArmLike::Client arm, kj::WaitScope& scope) {
  auto move = arm.servoCpRequest();
  setPose(move.initGoal(), 0.25);
  move.send().wait(scope);
  auto measured = arm.measuredCpRequest().send().wait(scope);
  std::printf("x: %.2f\n", measured.getValue().getPose().getX());

  auto question = arm.distanceRequest();
  setPose(question.initTo(), 1.25);
  std::printf("distance: %.2f\n", question.send().wait(scope).getValue());

  auto heard = kj::newPromiseAndFulfiller<void>();
  auto subscribe = arm.subscribeRequest();
  subscribe.setEvents(kj::heap<Listener>(kj::mv(heard.fulfiller)));
  subscribe.setEventMask(~0ul);
  subscribe.send().wait(scope);
  arm.holdRequest().send().wait(scope);
  heard.promise.wait(scope);
  std::printf("heard: stopped\n");

  printError("no goal", scope, [&] { return arm.servoCpRequest().send().ignoreResult(); });
  printError("not a number", scope, [&] {
    auto request = arm.servoCpRequest();
    setPose(request.initGoal(), std::nan(""));
    return request.send().ignoreResult();
  });
}

}  // namespace

int main(int, char** argv) {
  capnp::EzRpcClient client(argv[1]);
  auto& scope = client.getWaitScope();
  auto peer = client.getMain<suture::wire::Peer>();
  auto open = peer.openRequest();
  open.setComponent("PSM");
  open.setInterface("Arm");
  auto opened = open.send().wait(scope);
  talk(opened.getContract().castAs<ArmLike>(), scope);

  auto wrong = peer.openRequest();
  wrong.setComponent("PSN");
  wrong.setInterface("Arm");
  auto refused = wrong.send().wait(scope);
  std::printf("refused: %s\n", refused.getRefused().getText().cStr());
  return 0;
}
