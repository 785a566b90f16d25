// This runs any process of any deployment of the counter's components. Only the deployment file
// says what runs where, and what is connected to what.

#include <suture/deploy/workstation.h>

#include <array>

#include "01_counter/clicker.suture.h"
#include "01_counter/tally.suture.h"

int main(int argc, char** argv) {
  const std::array classes{
      suture::componentClass<counting::Tally>(),
      suture::componentClass<counting::Clicker>(),
  };
  return suture::workstationMain(argc, argv, classes);
}
