#pragma once
// The two programs of this folder that talk to each other are built as either end.

#include <suture/base/errors.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <iostream>
#include <string>

namespace evolution {

/// Keeps `provider` in process "server" until standard input ends.
inline void keep(const std::string& address, const std::string& name, suture::Component& provider) {
  suture::Manager manager("server", address);
  manager.add(name, provider);
  manager.start();
  std::cout << "ready" << std::endl;
  std::cin.get();
  manager.stop();
}

/// Says which manager the client asks for its provider, and how it connects.
struct Asking {
  std::string manager;                                   ///< the manager's address
  suture::ConnectOptions options{.laneRequired = true};  ///< no lane but the one named will do
};

/// Runs `talk()` in process "client", with `client` connected to the provider in the other.
template <class Talk>
void connected(const Asking& asking, suture::Component& client, const std::string& required,
               const std::string& provided, const Talk& talk) {
  suture::Manager manager("client", asking.manager);
  manager.add("Client", client);
  manager.start();
  manager.connect("Client/" + required, "server:" + provided, asking.options);
  talk();
  manager.stop();
}

/// Returns the exit status of `program serve ADDRESS` or `program ask ADDRESS LANE`.
template <class Serve, class Ask>
int eitherEnd(int argc, char** argv, const Serve& serve, const Ask& ask) {
  const std::string verb = argc > 1 ? argv[1] : "";
  if (argc != (verb == "ask" ? 4 : 3)) return 2;
  try {
    if (verb == "serve") {
      serve(argv[2]);
    } else {
      Asking asking{argv[2]};
      asking.options.lane = {argv[3]};
      ask(asking);
    }
    return 0;
  } catch (const suture::SetupError& error) {
    std::cout << error.what() << std::endl;
    return 1;
  }
}

}  // namespace evolution
