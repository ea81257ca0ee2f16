// SPDX-License-Identifier: MIT
#pragma once

/// Included by the main file of a program that runs plugins for another one, which must see a crash as the signal that
/// it is: sanitizers would end the program with a status of their own. Leaks are not looked for.
#if defined(__SANITIZE_ADDRESS__)
extern "C" const char* __asan_default_options() {
  return "handle_segv=0:handle_sigbus=0:handle_abort=0:detect_leaks=0";
}
#elif defined(__SANITIZE_THREAD__)
extern "C" const char* __tsan_default_options() { return "handle_segv=0:handle_sigbus=0:handle_abort=0"; }
#endif
