#include <suture/lane/frame/provider_port.h>

namespace suture::frame {

void ProviderPort::pump() {
  StatusPort::pump();
  if (told_ || !connection_->broken() || connection_->refusal().empty()) return;
  told_ = true;
  KJ_IF_MAYBE (listener, listener_) (*listener)->refuses(connection_->refusal());
}

}  // namespace suture::frame
