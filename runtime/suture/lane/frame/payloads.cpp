#include <suture/lane/frame/encoded_payloads.h>
#include <suture/lane/frame/payloads.h>
#include <suture/lane/frame/slot_payloads.h>

namespace suture::frame {

std::size_t rowBytes(const InterfaceInfo& contract) {
  std::size_t size = 0;
  for (const CommandInfo& one : contract.commands) {
    if (one.column >= 0) size += wordBytes(one.resultSize);
  }
  return size;
}

std::unique_ptr<Payloads> makePayloads(const InterfaceInfo& contract, Form form) {
  if (form == Form::Slots) return std::make_unique<SlotPayloads>(contract);
  return std::make_unique<EncodedPayloads>(contract);
}

}  // namespace suture::frame
