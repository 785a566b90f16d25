// An error of a call travels as a number and a text, perhaps from a newer build than this.

#include <gtest/gtest.h>
#include <suture/framing/remote_error.h>
#include <suture/loop/failure.h>

#include <string>

namespace suture::framing {
namespace {

kj::Exception told(const std::string& text) {
  return loop::failure(kj::Exception::Type::FAILED, text);
}

TEST(RemoteErrors, AreToldByNumberAndReason) {
  EXPECT_EQ(errcOf(remoteError(Errc::NotConnected)), Errc::NotConnected);
  EXPECT_EQ(errcOf(remoteError(Errc::NotPermitted)), Errc::NotPermitted);
  EXPECT_EQ(reasonOf(remoteError(Errc::Late)), "older than its ttl");
}

// The command may have run, so its sender must not take it for refused.
TEST(RemoteErrors, UnknownOnesLeaveTheOutcomeOpen) {
  const char* const texts[] = {"suture error 77: too hot", "suture error 0: too hot",
                               "suture error 4294967297: too hot"};
  for (const char* text : texts) {
    EXPECT_EQ(errcOf(told(text)), Errc::OutcomeUnknown) << text;
    EXPECT_EQ(reasonOf(told(text)), "too hot") << text;
  }
}

TEST(RemoteErrors, ForeignOnesKeepTheirWords) {
  EXPECT_EQ(errcOf(told("no such goal")), Errc::OutcomeUnknown);
  EXPECT_EQ(reasonOf(told("no such goal")), "no such goal");
}

}  // namespace
}  // namespace suture::framing
