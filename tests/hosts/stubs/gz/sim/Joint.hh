// See System.hh.
#pragma once

#include "gz/sim/System.hh"
