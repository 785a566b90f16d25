// This runs either process of deployment.json, or both components in one process of another file.

#include <suture/deploy/workstation.h>

#include <array>

#include "03_own_data_type/camera.suture.h"
#include "03_own_data_type/display.suture.h"

int main(int argc, char** argv) {
  const std::array classes{
      suture::componentClass<tracking::Camera>(),
      suture::componentClass<tracking::Display>(),
  };
  return suture::workstationMain(argc, argv, classes);
}
