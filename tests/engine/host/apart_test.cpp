// SPDX-License-Identifier: MIT
// What dies takes its step with it and nothing else; the caller hears all, and errors stay what they are.
#include "engine/host/apart.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

using Strings = Apart::Strings;

class Listener final : public Observer {
 public:
  void progress(std::string_view stage, double fraction) override {
    heard.push_back(std::string(stage) + " " + (fraction < 1 ? "goes on" : "is done"));
  }
  void log(LogLevel level, std::string_view message) override {
    heard.push_back((level == LogLevel::warning ? "warning: " : "") + std::string(message));
  }
  bool cancelled() const noexcept override { return cancels; }

  Strings heard;
  bool cancels = false;
};

/// Takes steps, which append to what is known, and lists how those ended that died.
Strings run_steps(const std::vector<void (*)(Strings&)>& steps) {
  Listener listener;
  return Apart::run(
      [&](Apart& apart, Observer&) {
        Strings known;
        for (const auto step : steps)
          if (const auto lost = apart.before_step())
            known.push_back("lost: " + lost->reason + " (" + std::to_string(lost->status) + ")");
          else
            step(known);
        return known;
      },
      listener);
}

TEST(Apart, StepsBuildOnEachOther) {
  EXPECT_EQ(run_steps({[](Strings& s) { s.push_back("a"); }, [](Strings& s) { s.push_back(s.back() + "b"); }}),
            (Strings{"a", "ab"}));
}

TEST(Apart, AStepThatDiesIsLostAloneHoweverItDies) {
  const Strings known =
      run_steps({[](Strings& s) { s.push_back("first"); }, [](Strings& s) { s.clear(), std::raise(SIGKILL); },
                 [](Strings&) { std::raise(SIGSEGV); }, [](Strings&) { std::abort(); }, [](Strings&) { std::_Exit(0); },
                 [](Strings& s) { s.push_back("last"); }});
  ASSERT_EQ(known.size(), 6u);
  EXPECT_EQ(known.front(), "first");
  EXPECT_EQ(known[1], "lost: its process was ended by SIGKILL, as by a system that is out of memory (5)");
  EXPECT_EQ(known[2], "lost: crashed with SIGSEGV outside of any plugin; please report this (1)");
  EXPECT_EQ(known[3], "lost: crashed with SIGABRT outside of any plugin; please report this (1)");
  EXPECT_EQ(known[4], "lost: ended its process with status 0 (5)");
  EXPECT_EQ(known.back(), "last");
}

TEST(Apart, TheFirstAndTheLastStepMayDieToo) {
  const auto die = [](Strings&) { std::raise(SIGKILL); };
  const Strings known = run_steps({die, [](Strings& s) { s.push_back("between"); }, die});
  ASSERT_EQ(known.size(), 3u);
  EXPECT_EQ(known[1], "between");
}

TEST(Apart, WhatDiesOutsideOfAStepIsAnError) {
  Listener listener;
  EXPECT_THROW(Apart::run([](Apart&, Observer&) -> Strings { std::_Exit(3); }, listener), PluginError);
}

TEST(Apart, ResultsMayHoldAnyBytes) {
  Listener listener;
  const Strings odd{"", std::string("\0\xff\n", 3), std::string(300'000, 'x')};
  EXPECT_EQ(Apart::run([&](Apart&, Observer&) { return odd; }, listener), odd);
}

TEST(Apart, TheObserverHearsAllInOrder) {
  Listener listener;
  Apart::run(
      [](Apart& apart, Observer& observer) {
        observer.log(LogLevel::info, "one");
        if (!apart.before_step()) observer.log(LogLevel::warning, "two");
        observer.progress("three", 1);
        return Strings{};
      },
      listener);
  EXPECT_EQ(listener.heard, (Strings{"one", "warning: two", "three is done"}));
}

TEST(Apart, TheObserverCancels) {
  Listener listener;
  listener.cancels = true;
  const auto wait = [](Apart& apart, Observer& observer) -> Strings {
    if (apart.before_step()) return {"lost"};
    while (!observer.cancelled()) usleep(1000);
    throw Cancelled();
  };
  EXPECT_THROW(Apart::run(wait, listener), Cancelled);
}

/// The error that `error` becomes on its way, from within a step.
template <class Kind>
Kind told(const Kind& error) {
  Listener listener;
  try {
    Apart::run(
        [&](Apart& apart, Observer&) -> Strings {
          if (!apart.before_step()) throw error;
          return {};
        },
        listener);
  } catch (const Kind& arrived) {
    return arrived;
  }
  throw std::logic_error("nothing was thrown");
}

TEST(Apart, ErrorsKeepTheirKindAndTheirWords) {
  InputError input(InputFault::truncated, "f.off: line 3", Remedy("a.code", {"p", "q"}, "say \xff"));
  input.attribute_to("solver_x");
  const InputError arrived = told(input);
  EXPECT_EQ(arrived.fault(), InputFault::truncated);
  EXPECT_STREQ(arrived.what(), input.what());
  EXPECT_EQ(arrived.coded_remedy().code, "a.code");
  EXPECT_EQ(arrived.coded_remedy().parameters, (Strings{"p", "q"}));
  EXPECT_EQ(arrived.plugin(), "solver_x");
  EXPECT_STREQ(told(OptionError("o", "r")).what(), "o; r");
  EXPECT_STREQ(told(CapabilityError("c")).what(), "c");
  EXPECT_STREQ(told(SampleError("s")).what(), "s");
  EXPECT_STREQ(told(RefusedError("r")).what(), "r");
  EXPECT_STREQ(told(PluginError("p")).what(), "p");
  EXPECT_STREQ(told(NumericalError("n")).what(), "n");
  EXPECT_STREQ(told(std::runtime_error("e")).what(), "e");
  EXPECT_NO_THROW(told(std::bad_alloc()));
}

}  // namespace
}  // namespace geodrome
