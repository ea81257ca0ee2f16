// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "geodrome/conformance.hpp"

namespace geodrome::conformance {

/// Registers one GoogleTest case per demand on a plugin, "<suite>.<demand>", dots in names becoming underscores. They
/// are judged in the test's process. A demand that does not apply is skipped, with the reason. Call it in main, before
/// RUN_ALL_TESTS:
///
///     int main(int argc, char** argv) {
///       using namespace geodrome::conformance;
///       testing::InitGoogleTest(&argc, argv);
///       register_tests(find_subject("build/lib/geodrome/solver_mine.so"));
///       return RUN_ALL_TESTS();
///     }
inline void register_tests(const Subject& subject) {
  class Case : public testing::Test {
   public:
    Case(Subject subject, Demand demand) : subject_(std::move(subject)), demand_(std::move(demand)) {}

   private:
    void TestBody() override {
      const Verdict verdict = judge(subject_, demand_.name);
      if (verdict.outcome == Outcome::not_applicable) GTEST_SKIP() << verdict.found;
      EXPECT_EQ(verdict.failures, 0u) << demand_.sentence << "\n  where: " << verdict.where
                                      << "\n  expected: " << verdict.expected << "\n  found: " << verdict.found;
    }
    Subject subject_;
    Demand demand_;
  };
  for (const Demand& demand : demands(subject.plugin.stage)) {
    std::string name = demand.name;
    for (char& c : name)
      if (c == '.') c = '_';
    testing::RegisterTest(subject.plugin.full_name().c_str(), name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [subject, demand]() -> testing::Test* { return new Case(subject, demand); });
  }
}

}  // namespace geodrome::conformance
