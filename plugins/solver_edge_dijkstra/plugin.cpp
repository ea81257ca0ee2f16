// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"
#include "plugins/solver_edge_dijkstra/edge_dijkstra.hpp"

GEODROME_PLUGIN(geodrome::EdgeDijkstra, .name = "edge_dijkstra",
                .summary = "shortest paths along edges (Dijkstra 1959): an upper bound, on any mesh", .licence = "MIT",
                .provides = geodrome::EdgeDijkstra::provides)
