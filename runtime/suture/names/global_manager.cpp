#include <suture/base/errors.h>
#include <suture/framing/link_server.h>
#include <suture/loop/control_thread.h>
#include <suture/loop/run_to_the_end.h>
#include <suture/names/global_manager.h>
#include <suture/names/manager_session.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace suture {
namespace {

constexpr Duration kPatience = std::chrono::seconds(10);
// This has room for a record and all that is around it.
constexpr std::size_t kMostOfAMessage = 2 * Registry::kMostBytesOfARecord;
constexpr std::size_t kMostLinks = 4096;  // as many as there are names

}  // namespace

class GlobalManager::Impl {
 public:
  Impl(loop::ControlThread& control, const net::Address& address, const Security& security)
      : names_(kj::refcounted<NameService>(control.timer())),
        policy_(security.policy),
        server_(
            control.port(), address,
            [this](std::shared_ptr<framing::Caller> caller) { return offerTo(std::move(caller)); },
            refusals_, {.messageBytes = kMostOfAMessage}, {.all = kMostLinks}, security.trust()) {}

  std::string address() const { return server_.address().text(); }

 private:
  capnp::Capability::Client offerTo(std::shared_ptr<framing::Caller> caller) {
    if (policy_.admits(caller->identity)) {
      return makeGlobalManager(kj::addRef(*names_), refusals_, std::move(caller));
    }
    const net::PeerIdentity who = caller->identity;
    return framing::turnAway(
        refusals_, who,
        "talk to the global manager: its policy has no rule for " + who.text() + ". Add one.");
  }

  kj::Own<NameService> names_;
  const Policy policy_;
  net::Refusals refusals_{"suture-manager"};
  framing::LinkServer server_;
};

GlobalManager::GlobalManager(loop::ControlThread& control, const std::string& address,
                             const Security& security)
    : control_(control) {
  const auto parsed = net::Address::parse(address);
  try {
    impl_ = control.run(kPatience, [&control, parsed, security] {
      return std::make_unique<Impl>(control, parsed, security);
    });
  } catch (const loop::ControlFailure& failure) {
    throw SetupError(failure.what());
  }
  address_ = impl_->address();
}

GlobalManager::~GlobalManager() {
  const std::string why =
      loop::runToTheEnd(control_, "suture-manager: waits to end: ", [this] { impl_.reset(); });
  if (!why.empty()) rt::printUnlessFull("suture-manager: " + why);
}

std::string GlobalManager::defaultAddress() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  const std::string directory = runtime != nullptr && *runtime != '\0'
                                    ? std::string(runtime) + "/suture"
                                    : "/tmp/suture-" + std::to_string(getuid());
  return "unix:" + directory + "/manager.sock";
}

void GlobalManager::makeDirectory(const std::string& address) {
  const auto parsed = net::Address::parse(address);
  if (parsed.kind != net::Address::Kind::Unix) return;
  const std::string directory = std::filesystem::path(parsed.path).parent_path();
  if (directory.empty() || mkdir(directory.c_str(), S_IRWXU) == 0) return;
  const std::string asked = "make the directory " + directory;
  if (errno != EEXIST)
    throw SetupError(asked, std::strerror(errno), "Choose another with --listen.");
  struct stat status {};
  const bool isDirectory = stat(directory.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
  if (!isDirectory || (status.st_uid != getuid() && status.st_uid != 0)) {
    throw SetupError(asked, "it is there, and is not a directory of this user",
                     "Choose another with --listen.");
  }
}

}  // namespace suture
