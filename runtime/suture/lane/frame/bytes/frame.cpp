#include <suture/lane/frame/bytes/frame.h>

namespace suture::frame {

const char* toString(Fault fault) {
  switch (fault) {
    case Fault::None: return "";
    case Fault::Checksum: return "a frame was damaged on its way (CRC)";
    case Fault::Size: return "a frame announces more than there can be";
    case Fault::Epoch: return "a frame belongs to another connection";
    case Fault::Sequence: return "a frame is missing or came twice";
    case Fault::Kind: return "a frame is of no known kind";
  }
  return "";
}

}  // namespace suture::frame
