// SPDX-License-Identifier: MIT
#pragma once

// The engine as a library: what the program `geodrome` does, from C++.
#include "geodrome/engine/accuracy.hpp"
#include "geodrome/engine/audit.hpp"
#include "geodrome/engine/formats.hpp"
#include "geodrome/engine/input.hpp"
#include "geodrome/engine/jobs.hpp"
#include "geodrome/engine/named_points.hpp"
#include "geodrome/engine/pipeline.hpp"
#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/engine/plugin_text.hpp"
#include "geodrome/engine/remedies.hpp"
#include "geodrome/engine/row_set.hpp"
#include "geodrome/engine/row_sink.hpp"
#include "geodrome/engine/session.hpp"
#include "geodrome/engine/version.hpp"
