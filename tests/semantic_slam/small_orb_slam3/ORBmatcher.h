// SPDX-License-Identifier: MIT
#pragma once

#include "host_types.hpp"
