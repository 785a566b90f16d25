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

/// Runs `talk()` in process "client", with `client` connected to the provider in the other.
template <class Talk>
void connected(const std::string& address, suture::Component& client, const std::string& required,
               const std::string& provided, const Talk& talk) {
  suture::Manager manager("client", address);
  manager.add("Client", client);
  manager.start();
  manager.connect("Client/" + required, "server:" + provided);
  talk();
  manager.stop();
}

/// The exit status of `program serve ADDRESS` or `program ask ADDRESS`.
template <class Serve, class Ask>
int eitherEnd(int argc, char** argv, const Serve& serve, const Ask& ask) {
  if (argc != 3) return 2;
  try {
    if (std::string(argv[1]) == "serve") {
      serve(argv[2]);
    } else {
      ask(argv[2]);
    }
    return 0;
  } catch (const suture::SetupError& error) {
    std::cout << error.what() << std::endl;
    return 1;
  }
}

}  // namespace evolution
