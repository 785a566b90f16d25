#include <suture/testing/trace.h>

namespace suture {
namespace {

const char* verbOf(VirtualTime::Kind kind) {
  switch (kind) {
    case VirtualTime::Kind::Send: return "sends";
    case VirtualTime::Kind::Execute: return "executes";
    case VirtualTime::Kind::Event: return "handles";
    case VirtualTime::Kind::Status: return "hears of status";
  }
  return "";
}

}  // namespace

std::string toString(const Trace& trace) {
  std::string text;
  for (const TraceEntry& entry : trace) {
    text += std::to_string(entry.time.count()) + " ns: " + entry.thread + " " + verbOf(entry.kind) +
            " " + entry.what + " #" + std::to_string(entry.number) + "\n";
  }
  return text;
}

}  // namespace suture
