#include <suture/lane/frame/payloads/encoded_payloads.h>
#include <suture/lane/frame/payloads/payloads.h>
#include <suture/lane/frame/payloads/slot_payloads.h>

namespace suture::frame {

std::unique_ptr<Payloads> makePayloads(const InterfaceInfo& contract, Form form) {
  if (form == Form::Slots) return std::make_unique<SlotPayloads>(contract);
  return std::make_unique<EncodedPayloads>(contract);
}

}  // namespace suture::frame
