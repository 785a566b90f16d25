// 01_counter            one process
// 01_counter provider   \ two processes, on machines of their own if they like;
// 01_counter client     / `suture-manager` must run

#include <suture/base/errors.h>
#include <suture/base/plain.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "01_counter/clicker.h"
#include "01_counter/tally.h"

namespace {

void run(const std::string& role) {
  counting::Tally tally;
  counting::Clicker clicker;
  const bool alone = role == "both";
  const auto address = suture::GlobalManager::defaultAddress();
  const auto manager = alone ? std::make_unique<suture::Manager>(role)
                             : std::make_unique<suture::Manager>(role, address);

  if (role != "client") manager->add("Tally", tally);
  if (role != "provider") manager->add("Clicker", clicker);
  manager->start();
  if (alone) manager->connect("Clicker/Counter", "Tally/Counter");
  if (role == "client") manager->connect("Clicker/Counter", "provider:Tally/Counter");

  std::this_thread::sleep_for(std::chrono::seconds(role == "provider" ? 60 : 5));
  manager->stop();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc > 1 ? argv[1] : "both");
  } catch (const suture::SetupError& error) {
    std::fprintf(stderr, "%s\n", suture::explained(error.what()).c_str());
    return 1;
  }
}
