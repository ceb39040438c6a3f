/// Does a device give the bits that "scalar" gives?
#pragma once
#include "opencl/device.h"

namespace weft::opencl {

/// Largest difference between the fixed programs on this device and their stored values; 0 only if all bits agree.
float largest_difference(const Device& device);

} // namespace weft::opencl
