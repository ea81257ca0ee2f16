// SPDX-License-Identifier: MIT
#include "geodrome/engine/boundary.hpp"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "engine/host/crash_words.hpp"

namespace geodrome {
namespace {

/// Read in signal handlers, so it must exist from a thread's first moment: lazy allocation would not be safe there.
__attribute__((tls_model("initial-exec"))) thread_local const PluginInfo* running = nullptr;

std::atomic<bool> handlers_installed{false};

/// Where the words on a crash go; null: to standard error. Set before handlers are installed.
char* crash_words = nullptr;
std::size_t crash_words_size = 0;

/// What runs on any thread, so that a crash on a thread that a plugin started itself finds its plugin too: a few slots,
/// claimed by outermost scopes. A scope that finds none free goes without.
constexpr int slot_count = 64, no_slot = -1;
std::atomic<const PluginInfo*> running_somewhere[slot_count];
thread_local int slot = no_slot;

void claim_slot(const PluginInfo& plugin) noexcept {
  for (int i = 0; i < slot_count && slot == no_slot; ++i) {
    const PluginInfo* free = nullptr;
    if (running_somewhere[i].compare_exchange_strong(free, &plugin)) slot = i;
  }
}

void release_slot() noexcept {
  if (slot != no_slot) running_somewhere[slot] = nullptr;
  slot = no_slot;
}

const PluginInfo* suspect() noexcept {
  if (running != nullptr) return running;
  for (const auto& other : running_somewhere)
    if (const PluginInfo* plugin = other) return plugin;
  return nullptr;
}

constexpr std::size_t handler_stack_size = 64 << 10;

void drop_handler_stack(void* memory) noexcept {
  const stack_t none{nullptr, SS_DISABLE, 0};
  sigaltstack(&none, nullptr);
  delete[] static_cast<char*>(memory);
}

/// A stack of its own for the handler, one per thread that runs plugins, so that a stack overflow can be told too. It
/// hangs on a key of pthreads: to register the destructor of a thread_local glibc allocates, and aborts if it cannot.
void provide_handler_stack() noexcept {
  static pthread_key_t key;
  static const bool has_key = pthread_key_create(&key, drop_handler_stack) == 0;
  if (!has_key || pthread_getspecific(key) != nullptr) return;
  char* memory = new (std::nothrow) char[handler_stack_size];
  if (memory == nullptr) return;
  if (pthread_setspecific(key, memory) != 0) return drop_handler_stack(memory);
  const stack_t stack{memory, 0, handler_stack_size};
  sigaltstack(&stack, nullptr);
}

/// Appends as much as there is room for.
void note(const char* text) noexcept {
  std::size_t length = std::strlen(crash_words);
  while (*text != '\0' && length + 1 < crash_words_size) crash_words[length++] = *text++;
  crash_words[length] = '\0';
}

/// Async-signal-safe: nothing here allocates or locks.
void say(const char* text) noexcept {
  if (crash_words != nullptr) return note(text);
  for (std::size_t left = std::strlen(text); left > 0;) {
    const ssize_t count = write(STDERR_FILENO, text, left);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    text += count, left -= static_cast<std::size_t>(count);
  }
}

[[noreturn]] void end_with_message(const char* what, const char* detail) noexcept {
  const PluginInfo* plugin = suspect();
  const bool to_people = crash_words == nullptr;
  if (to_people) say("geodrome: ");
  if (plugin == nullptr) {
    for (const char* part : {what, detail, " outside of any plugin; please report this"}) say(part);
  } else {
    const char* stage = plugin->stage.c_str();
    for (const char* part : {"plugin ", stage, "_", plugin->name.c_str(), " (stage ", stage, ") ", what, detail,
                             " while computing; choose another ", stage, " plugin or report this to its author (",
                             plugin->file.c_str(), ")"})
      say(part);
  }
  if (to_people) say("\n");
  _exit(plugin == nullptr ? 1 : 5);
}

const char* signal_name(int signal) noexcept {
  switch (signal) {
    case SIGSEGV:
      return "SIGSEGV";
    case SIGBUS:
      return "SIGBUS";
    case SIGFPE:
      return "SIGFPE";
    case SIGILL:
      return "SIGILL";
    case SIGABRT:
      return "SIGABRT";
    default:
      return "a signal";
  }
}

void on_crash(int signal) { end_with_message("crashed with ", signal_name(signal)); }

[[noreturn]] void end_without_memory() noexcept {
  for (const char* part : {"geodrome: out of memory; ", out_of_memory_remedy, "\n"}) say(part);
  _exit(4);
}

/// There is no exception where memory does not suffice for one.
bool memory_ran_out() noexcept {
  void* volatile some = std::malloc(256);  // compilers leave out memory that nobody looks at
  std::free(some);
  return some == nullptr;
}

[[noreturn]] void on_terminate() noexcept {
  if (!std::current_exception()) {
    if (memory_ran_out()) end_without_memory();
    end_with_message("called std::terminate", "");
  }
  try {
    throw;
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (const std::exception& error) {
    end_with_message("ended the program with an exception: ", error.what());
  } catch (...) {
    end_with_message("ended the program with an exception of unknown type", "");
  }
}

}  // namespace

PluginScope::PluginScope(const PluginInfo& plugin) noexcept : previous_(running) {
  if (previous_ == nullptr && handlers_installed.load(std::memory_order_relaxed)) {
    provide_handler_stack();
    claim_slot(plugin);
  }
  running = &plugin;
}

PluginScope::~PluginScope() {
  running = previous_;
  if (previous_ == nullptr) release_slot();
}

void install_crash_handlers() noexcept {
  std::set_terminate(on_terminate);
  provide_handler_stack();
  handlers_installed = true;
  struct sigaction action {};
  action.sa_handler = on_crash;
  action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(signal, &action, nullptr);
}

void tell_crashes_to(char* words, std::size_t size) noexcept {
  words[0] = '\0';
  crash_words = words, crash_words_size = size;
  install_crash_handlers();
}

}  // namespace geodrome
