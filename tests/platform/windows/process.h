// SPDX-License-Identifier: MIT
#pragma once
extern "C" int _getpid();
