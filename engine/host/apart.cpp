// SPDX-License-Identifier: MIT
#include "engine/host/apart.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <memory>
#include <mutex>
#include <new>
#include <utility>

#include "engine/formats/number_text.hpp"
#include "engine/formats/parse_number.hpp"
#include "engine/host/child.hpp"
#include "engine/host/crash_words.hpp"
#include "engine/host/messages.hpp"
#include "engine/host/told_error.hpp"

namespace geodrome {

/// What all processes see.
struct Apart::Shared {
  std::atomic<bool> cancelled{false}, done{false};
  char words[2048] = "";  ///< of a crash
};
static_assert(std::atomic<bool>::is_always_lock_free, "processes share it");

namespace {

constexpr const char *of_progress = "progress", *of_log = "log", *of_result = "result", *of_error = "error";

[[noreturn]] void cannot(const char* what) { throw PluginError(std::string(what) + ": " + std::strerror(errno)); }

/// What is left in buffers would be written by every copy.
void flush_streams() {
  std::cout.flush();
  std::clog.flush();
  std::fflush(nullptr);
}

/// Hands on what it hears to the process that began it all. Progress comes often and is told seldom.
class Teller final : public Observer {
 public:
  Teller(int descriptor, const Observer& first, const std::atomic<bool>& cancelled)
      : descriptor_(descriptor), first_(first), cancelled_(cancelled) {}

  void progress(std::string_view stage, double fraction) override {
    constexpr std::chrono::milliseconds pause(20);
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (stage == stage_ && fraction < 1 && now - told_ < pause) return;
    stage_ = stage, told_ = now;
    send(descriptor_, {of_progress, stage_, number_text(fraction)});
  }
  void log(LogLevel level, std::string_view message) override {
    const std::lock_guard lock(mutex_);
    send(descriptor_, {of_log, std::to_string(static_cast<int>(level)), std::string(message)});
  }
  std::string words(const Remedy& remedy) const override { return first_.words(remedy); }
  bool cancelled() const noexcept override { return cancelled_; }

 private:
  int descriptor_;
  const Observer& first_;
  const std::atomic<bool>& cancelled_;
  std::mutex mutex_;
  std::string stage_;
  std::chrono::steady_clock::time_point told_;
};

/// The caller alone decides what an interrupt means; a copy ends with the process that it was made by.
void become_child_of(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
}

void set_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_IGN);
  std::signal(SIGCHLD, SIG_DFL);
}

LostStep how_it_ended(int status, char* words) {
  LostStep lost{words, 5};
  words[0] = '\0';
  if (!lost.reason.empty()) {
    lost.status = WEXITSTATUS(status);
  } else if (WIFSIGNALED(status)) {
    ChildEnd end;
    end.signal = WTERMSIG(status);
    lost.reason = "its process was ended by " + signal_name(end) +
                  (end.signal == SIGKILL ? ", as by a system that is out of memory" : "");
  } else {
    lost.reason = "ended its process with status " + std::to_string(WEXITSTATUS(status));
  }
  return lost;
}

int wait_for_end(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

/// A process that is killed, with all copies, where the caller leaves early.
class FirstChild {
 public:
  explicit FirstChild(pid_t id) : id_(id) {}
  ~FirstChild() {
    if (id_ <= 0) return;
    kill(id_, SIGKILL);
    wait_for_end(id_);
  }
  int wait() { return wait_for_end(std::exchange(id_, 0)); }
  FirstChild(const FirstChild&) = delete;
  FirstChild& operator=(const FirstChild&) = delete;

 private:
  pid_t id_;
};

struct MessagePipe {
  int ends[2] = {-1, -1};
  MessagePipe() {
    if (pipe2(ends, O_CLOEXEC) != 0) cannot("cannot make a pipe");
  }
  ~MessagePipe() {
    close_end(0);
    close_end(1);
  }
  void close_end(int i) {
    if (ends[i] >= 0) close(std::exchange(ends[i], -1));
  }
  MessagePipe(const MessagePipe&) = delete;
  MessagePipe& operator=(const MessagePipe&) = delete;
};

/// Tells the observer what the children tell, and them whether it cancels, until there is a result or they are gone.
std::optional<Message> listen(int descriptor, std::atomic<bool>& cancelled, Observer& observer) {
  constexpr int milliseconds = 50;
  MessageReader reader;
  for (bool open = true; open;) {
    pollfd stream{descriptor, POLLIN, 0};
    const int ready = poll(&stream, 1, milliseconds);
    if (observer.cancelled()) cancelled = true;
    if (ready > 0) open = reader.read_from(descriptor);
    while (std::optional<Message> message = reader.next()) {
      if ((*message)[0] == of_progress)
        observer.progress((*message)[1], input::parse_number((*message)[2]).value);
      else if ((*message)[0] == of_log)
        observer.log(static_cast<LogLevel>(std::stoi((*message)[1])), (*message)[2]);
      else
        return message;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<LostStep> Apart::before_step() {
  flush_streams();
  const pid_t self = getpid(), copy = fork();
  if (copy < 0) {
    observer_.log(LogLevel::warning, "no process can be made for the next step (" + std::string(std::strerror(errno)) +
                                         "): if it dies, nothing is left");
    return std::nullopt;
  }
  if (copy == 0) {
    become_child_of(self);
    return std::nullopt;
  }
  const int status = wait_for_end(copy);
  if (shared_.done) _exit(0);
  return how_it_ended(status, shared_.words);
}

void Apart::serve(const Work& work, const Observer& first, Shared& shared, int descriptor) {
  set_signals();
  tell_crashes_to(shared.words, sizeof shared.words);
  Teller teller(descriptor, first, shared.cancelled);
  Apart apart(shared, teller);
  Message answer{of_result};
  try {
    const Strings result = work(apart, teller);
    answer.insert(answer.end(), result.begin(), result.end());
  } catch (const std::exception& error) {
    const Message words = told(error);
    answer = {of_error};
    answer.insert(answer.end(), words.begin(), words.end());
  }
  flush_streams();
  shared.done = send(descriptor, answer);
  _exit(0);
}

Apart::Strings Apart::run(const Work& work, Observer& observer) {
  void* page = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) cannot("cannot share memory with a child process");
  const std::unique_ptr<Shared, void (*)(Shared*)> shared(new (page) Shared,
                                                          [](Shared* old) { munmap(old, sizeof(Shared)); });
  MessagePipe pipe;
  flush_streams();
  const pid_t self = getpid(), first = fork();
  if (first < 0) cannot("cannot make a child process");
  if (first == 0) {
    become_child_of(self);
    pipe.close_end(0);
    serve(work, observer, *shared, pipe.ends[1]);
  }
  FirstChild child(first);
  pipe.close_end(1);
  const std::optional<Message> answer = listen(pipe.ends[0], shared->cancelled, observer);
  const int status = child.wait();
  if (!answer) throw PluginError(how_it_ended(status, shared->words).reason);
  const Strings rest(answer->begin() + 1, answer->end());
  if ((*answer)[0] == of_error) throw_told(rest);
  return rest;
}

}  // namespace geodrome
