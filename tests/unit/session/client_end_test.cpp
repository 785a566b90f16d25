// The client's end of a connection tells once why it carries nothing any more.

#include <gtest/gtest.h>
#include <suture/lane/client_end.h>
#include <suture/session/client/notices_receiver.h>

#include <string>
#include <vector>

#include "reference/played_channel.h"

namespace suture {
namespace {

using Reasons = std::vector<std::string>;

class ClientEnds : public testing::Test {
 public:
  ~ClientEnds() noexcept override {}

 protected:
  void listen() {
    end->onBroken([this](std::string why) { told.push_back(std::move(why)); });
  }

  const std::shared_ptr<Channel> channel = reference::armChannel(reference::playedEnds(), "frame");
  kj::Own<ClientEnd> end = kj::refcounted<ClientEnd>(channel);
  Reasons told;
};

TEST_F(ClientEnds, TellTheFirstReason) {
  listen();
  end->tellBroken("silent");
  end->tellBroken("closed");
  EXPECT_EQ(told, Reasons{"silent"});
}

TEST_F(ClientEnds, TellALaterListener) {
  end->tellBroken("silent");
  end->tellBroken("closed");
  listen();
  EXPECT_EQ(told, Reasons{"silent"});
}

// The end of what carried the connection may be noticed before the reason comes.
TEST_F(ClientEnds, TellWhatTheProviderHasRefused) {
  Reasons lost;
  kj::EventLoop loop;
  kj::WaitScope scope(loop);
  auto news = kj::refcounted<ProviderNews>();
  wire::Notices::Client provider(kj::heap<NoticesReceiver>(
      kj::addRef(*news), nullptr, [&lost](std::string why) { lost.push_back(std::move(why)); }));
  const auto refuse = [&] {
    auto request = provider.refusedRequest();
    request.setWhy("a frame makes no sense");
    request.send().ignoreResult().wait(scope);
  };
  listen();
  refuse();
  news->passOnTo(kj::addRef(*end));
  EXPECT_EQ(told, Reasons{"refused: a frame makes no sense"});
  refuse();
  EXPECT_EQ(lost, Reasons(2, "refused: a frame makes no sense"));
  EXPECT_EQ(told.size(), 1u);
}

TEST_F(ClientEnds, TellNothingOnceTheyAreClosed) {
  listen();
  end->close(ChannelStatus::Closed);
  end->tellBroken("silent");
  EXPECT_EQ(told, Reasons{});
  EXPECT_EQ(channel->status, ChannelStatus::Closed);
}

}  // namespace
}  // namespace suture
