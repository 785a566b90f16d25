#pragma once
// The simplest capability there is.

#include <suture/loop/kj_comparisons.h>  // first

#include <echo.capnp.h>
#include <suture/loop/failure.h>

#include <cstring>

namespace suture::framing {

class EchoServer final : public test::Echo::Server {
 protected:
  kj::Promise<void> echo(EchoContext context) override {
    context.getResults().setData(context.getParams().getData());
    return kj::READY_NOW;
  }
  kj::Promise<void> fail(FailContext context) override {
    return loop::failure(kj::Exception::Type::FAILED, context.getParams().getText().cStr());
  }
  kj::Promise<void> never(NeverContext) override { return kj::NEVER_DONE; }
};

/// Returns how many bytes come back of `size`.
inline kj::Promise<std::size_t> echo(test::Echo::Client client, std::size_t size) {
  auto request = client.echoRequest();
  memset(request.initData(size).begin(), 5, size);
  return request.send().then([](auto&& response) { return response.getData().size(); });
}

}  // namespace suture::framing
