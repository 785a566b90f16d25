#include "parts/force.h"
