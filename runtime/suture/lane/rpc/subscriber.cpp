#include <suture/codec/codec.h>
#include <suture/lane/rpc/subscriber.h>

namespace suture::rpc {

kj::Promise<void> Subscriber::event(const rt::EventRecord& record) {
  const codec::Codec& codec = contract_.codec();
  if (record.event >= codec.events.size()) return kj::READY_NOW;
  const codec::EventCodec& known = codec.events[record.event];
  auto request = client_.typelessRequest(codec.subscriber, known.method, nullptr);
  known.payload.encode(record.payload(), request);
  known.stamp.set(request, toNanoseconds(record.stamp));
  return request.send().ignoreResult();
}

kj::Promise<void> Subscriber::row(const rt::StateTable::Row& row,
                                  std::span<const std::byte* const> slots) {
  const codec::Codec& codec = contract_.codec();
  auto request = client_.typelessRequest(codec.subscriber, 0, nullptr);
  codec.row.encode(row, slots, contract_.wireColumns, request);
  return request.send().ignoreResult();
}

}  // namespace suture::rpc
