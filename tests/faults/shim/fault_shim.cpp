// SPDX-License-Identifier: MIT
// A library for LD_PRELOAD that makes calls into the system fail, come short, or find a file changed, as the variable
// GEODROME_FAULT says (fault_plan.hpp). It stands between the program and glibc; the program's children are left alone.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>

#include "tests/faults/shim/fault_plan.hpp"

using geodrome::faults::plan;

namespace {

/// The function of glibc that is hidden by the one of this library.
template <class Function>
Function* real(Function*, const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// Bytes that a transfer may move: all, or as few as the plan says.
size_t allowed(size_t size) {
  const auto shortened = static_cast<size_t>(plan().shortened);
  return plan().shortened < 0 || size < shortened ? size : shortened;
}

/// Carries a transfer out, in full or short, or fails.
template <class Transfer>
ssize_t transfer(const char* call, int descriptor, size_t size, Transfer&& move) {
  if (!plan().strikes(call, descriptor)) return move(size);
  if (plan().shortened >= 0) return allowed(size) == 0 ? 0 : move(allowed(size));
  return plan().goes_on() ? move(size) : plan().fail<ssize_t>();
}

/// Calls the function that `call` is named after, unless the plan strikes at `where` (a path or a descriptor).
template <class Where, class Call>
auto unless_struck(const char* call, Where where, Call&& go_on) -> decltype(go_on()) {
  if (plan().strikes(call, where) && !plan().goes_on()) return plan().fail<decltype(go_on())>();
  return go_on();
}

using MainFunction = int(int, char**, char**);
using Hook = void();
MainFunction* main_of_program = nullptr;

int main_under_faults(int argc, char** argv, char** environment) {
  plan().begin();
  return main_of_program(argc, argv, environment);
}

mode_t mode_of(int flags, va_list list) { return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(list, mode_t) : 0; }

}  // namespace

extern "C" {

#define GEODROME_OPEN(name)                                                                           \
  int name(const char* path, int flags, ...) {                                                        \
    va_list list;                                                                                     \
    va_start(list, flags);                                                                            \
    const mode_t mode = mode_of(flags, list);                                                         \
    va_end(list);                                                                                     \
    static auto* next = reinterpret_cast<int (*)(const char*, int, mode_t)>(dlsym(RTLD_NEXT, #name)); \
    const char* call = (flags & O_ACCMODE) == O_RDONLY ? "open" : "create";                           \
    return unless_struck(call, path, [&] { return next(path, flags, mode); });                        \
  }
GEODROME_OPEN(open)
GEODROME_OPEN(open64)
#undef GEODROME_OPEN

#define GEODROME_FOPEN(name)                                                                          \
  FILE* name(const char* path, const char* mode) {                                                    \
    static auto* next = real(&name, #name);                                                           \
    return unless_struck(mode[0] == 'r' ? "open" : "create", path, [&] { return next(path, mode); }); \
  }
GEODROME_FOPEN(fopen)
GEODROME_FOPEN(fopen64)
#undef GEODROME_FOPEN

ssize_t read(int descriptor, void* data, size_t size) {
  static auto* next = real(&read, "read");
  return transfer("read", descriptor, size, [&](size_t part) { return next(descriptor, data, part); });
}

ssize_t write(int descriptor, const void* data, size_t size) {
  static auto* next = real(&write, "write");
  return transfer("write", descriptor, size, [&](size_t part) { return next(descriptor, data, part); });
}

#define GEODROME_TRANSFER_AT(name, kind, data_type)                                                             \
  ssize_t name(int descriptor, data_type data, size_t size, off_t offset) {                                     \
    static auto* next = real(&name, #name);                                                                     \
    return transfer(kind, descriptor, size, [&](size_t part) { return next(descriptor, data, part, offset); }); \
  }
GEODROME_TRANSFER_AT(pread, "pread", void*)
GEODROME_TRANSFER_AT(pread64, "pread", void*)
GEODROME_TRANSFER_AT(pwrite, "pwrite", const void*)
GEODROME_TRANSFER_AT(pwrite64, "pwrite", const void*)
#undef GEODROME_TRANSFER_AT

int fsync(int descriptor) {
  static auto* next = real(&fsync, "fsync");
  return unless_struck("fsync", descriptor, [&] { return next(descriptor); });
}

/// Closes all the same, as Linux does when it reports an error.
int close(int descriptor) {
  static auto* next = real(&close, "close");
  const bool struck = plan().strikes("close", descriptor);
  const int result = next(descriptor);
  return struck && !plan().goes_on() ? plan().fail<int>() : result;
}

#define GEODROME_RESIZE(name)                                                              \
  int name(int descriptor, off_t size) noexcept {                                          \
    static auto* next = real(&name, #name);                                                \
    return unless_struck("ftruncate", descriptor, [&] { return next(descriptor, size); }); \
  }
GEODROME_RESIZE(ftruncate)
GEODROME_RESIZE(ftruncate64)
#undef GEODROME_RESIZE

#define GEODROME_RESERVE(name)                                                                           \
  int name(int descriptor, int mode, off_t offset, off_t size) {                                         \
    static auto* next = real(&name, #name);                                                              \
    return unless_struck("fallocate", descriptor, [&] { return next(descriptor, mode, offset, size); }); \
  }
GEODROME_RESERVE(fallocate)
GEODROME_RESERVE(fallocate64)
#undef GEODROME_RESERVE

int flock(int descriptor, int operation) noexcept {
  static auto* next = real(&flock, "flock");
  return unless_struck("flock", descriptor, [&] { return next(descriptor, operation); });
}

int rename(const char* from, const char* to) noexcept {
  static auto* next = real(&rename, "rename");
  return unless_struck("rename", to, [&] { return next(from, to); });
}

int unlink(const char* path) noexcept {
  static auto* next = real(&unlink, "unlink");
  return unless_struck("unlink", path, [&] { return next(path); });
}

int remove(const char* path) noexcept {
  static auto* next = real(&remove, "remove");
  return unless_struck("unlink", path, [&] { return next(path); });
}

int stat(const char* path, struct stat* status) noexcept {
  static auto* next = real(&stat, "stat");
  return unless_struck("stat", path, [&] { return next(path, status); });
}

int fstat(int descriptor, struct stat* status) noexcept {
  static auto* next = real(&fstat, "fstat");
  return unless_struck("fstat", descriptor, [&] { return next(descriptor, status); });
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                   void* argument) noexcept {
  static auto* next = real(&pthread_create, "pthread_create");
  if (plan().strikes("thread", "")) return plan().error;  // a pthread function returns its error
  return next(thread, attributes, start, argument);
}

/// What the loader and the constructors of libraries do, before any code of the program runs, is left alone.
int __libc_start_main(MainFunction* main, int argc, char** argv, Hook* init, Hook* fini, Hook* rtld_fini, void* stack) {
  static auto* next = real(&__libc_start_main, "__libc_start_main");
  main_of_program = main;
  return next(main_under_faults, argc, argv, init, fini, rtld_fini, stack);
}

// dlsym may itself allocate, so these take glibc's own names.
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* old, size_t size);

void* malloc(size_t size) noexcept {
  return unless_struck("malloc", "", [&] { return __libc_malloc(size); });
}

void* calloc(size_t count, size_t size) noexcept {
  return unless_struck("malloc", "", [&] { return __libc_calloc(count, size); });
}

void* realloc(void* old, size_t size) noexcept {
  return unless_struck("malloc", "", [&] { return __libc_realloc(old, size); });
}

}  // extern "C"
