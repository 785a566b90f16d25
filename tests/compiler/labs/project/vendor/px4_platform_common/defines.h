#pragma once
// NuttX says this of a symbol that other modules see.
#define __EXPORT __attribute__((visibility("default")))
