#pragma once
// Tests make either side of a connection by frames with this.

#include <suture/lane/frame/client_side.h>
#include <suture/lane/frame/provider_side.h>

#include <memory>
#include <utility>

namespace suture::frame {

/// Makes a side; `rest` is what its constructor takes behind the number.
template <class Side, class... Rest>
std::shared_ptr<Side> makeSide(std::shared_ptr<Channel> channel, std::uint32_t number,
                               Form form = Form::Slots, Rest&&... rest) {
  auto payloads = makePayloads(channel->info, form);
  return std::make_shared<Side>(std::move(channel), std::move(payloads), number,
                                std::forward<Rest>(rest)...);
}

}  // namespace suture::frame
