// See model.hpp.
#pragma once

#include "pinocchio/multibody/model.hpp"
