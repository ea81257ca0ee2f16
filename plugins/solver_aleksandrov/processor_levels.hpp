// SPDX-License-Identifier: MIT
#pragma once

/// Before a function: compiled for several levels of the processor, one of which is chosen when the plugin is loaded.
/// No fused multiply-adds at any, so that results are the same. Sanitizers do not go with this.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define GEODROME_PROCESSOR_LEVELS __attribute__((target_clones("avx2", "default")))
#else
#define GEODROME_PROCESSOR_LEVELS
#endif
