// Every demand of the contract of this plugin's stage, on this one.
#include <geodrome/conformance/gtest.hpp>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  geodrome::conformance::register_tests(geodrome::conformance::find_subject(PLUGIN));
  return RUN_ALL_TESTS();
}
