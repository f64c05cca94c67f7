#pragma once
/// All of rme but its JSON form (rme/network/json.hpp, target rme::json).
#include <rme/control/compensation.hpp>
#include <rme/core/payload.hpp>
#include <rme/core/ring_buffer.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>
