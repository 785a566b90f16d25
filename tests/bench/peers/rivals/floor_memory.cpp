#include "rivals/floor_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

#include "harness/fail.h"

namespace peers {
namespace {

struct Rings {
  Ring up, down;
};

/// Maps the rings of that server; the process that comes first makes them.
Rings& ringsOf(const Options& options, int server) {
  const std::string file = options.place + "." + std::to_string(server) + ".rings";
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT, 0600);
  if (descriptor < 0 || ftruncate(descriptor, sizeof(Rings)) != 0) fail("no rings in " + file);
  void* const memory =
      mmap(nullptr, sizeof(Rings), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  close(descriptor);
  if (memory == MAP_FAILED) fail("no memory for the rings");
  return *static_cast<Rings*>(memory);
}

class MemoryClient final : public Client {
 public:
  MemoryClient(Rings& rings, Waiting waiting) : rings_(rings), waiting_(waiting) {}

  void echo(const Pose& sent, Pose& back) override {
    send(Kind::Echo, sent);
    load(rings_.down.peek(waiting_).pose, back);
    rings_.down.release(waiting_);
  }

  void echo(const Blob& sent, Blob& back) override {
    const std::size_t bytes = sent.data.size() * sizeof(double);
    Place& place = rings_.up.claim(waiting_);
    place.kind = Kind::Blob;
    place.blobBytes = sizeof(double) + bytes;
    std::memcpy(rings_.up.blob(), &sent.timestamp, sizeof(double));
    std::memcpy(rings_.up.blob() + sizeof(double), sent.data.data(), bytes);
    rings_.up.commit(waiting_);

    const std::size_t arrived = rings_.down.peek(waiting_).blobBytes - sizeof(double);
    std::memcpy(&back.timestamp, rings_.down.blob(), sizeof(double));
    back.data.resize(arrived / sizeof(double));
    std::memcpy(back.data.data(), rings_.down.blob() + sizeof(double), arrived);
    rings_.down.release(waiting_);
  }

  void send(const Pose& pose) override { send(Kind::Push, pose); }

 private:
  void send(Kind kind, const Pose& pose) {
    Place& place = rings_.up.claim(waiting_);
    place.kind = kind;
    store(pose, place.pose);
    rings_.up.commit(waiting_);
  }

  Rings& rings_;
  const Waiting waiting_;
};

}  // namespace

void MemoryPeer::serve(const Options& options, const Sink& sink,
                       const std::function<void()>& ready) {
  Rings& rings = ringsOf(options, options.server);
  sink.control().exitWhenToldBeside();
  ready();
  for (Pose pose;;) {
    const Place& request = rings.up.peek(waiting_);
    if (request.kind == Kind::Push) {
      load(request.pose, pose);
      rings.up.release(waiting_);
      sink(pose);
      continue;
    }
    Place& answer = rings.down.claim(waiting_);
    if (request.kind == Kind::Blob) {
      answer.blobBytes = request.blobBytes;
      std::memcpy(rings.down.blob(), rings.up.blob(), request.blobBytes);
    } else {
      load(request.pose, pose);
      store(pose, answer.pose);
    }
    rings.up.release(waiting_);
    rings.down.commit(waiting_);
  }
}

std::unique_ptr<Client> MemoryPeer::client(const Options& options, int server) {
  return std::make_unique<MemoryClient>(ringsOf(options, server), waiting_);
}

}  // namespace peers
