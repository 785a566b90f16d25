#pragma once
#include <suture/annotate.h>
#include <suture/component/component.h>
