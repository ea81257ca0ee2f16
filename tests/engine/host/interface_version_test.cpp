// SPDX-License-Identifier: MIT
// Which versions of the border a host takes, descriptors of older versions, and extensions.
#include <gtest/gtest.h>

#include "engine/host/handshake.hpp"
#include "geodrome/engine/plugin_host.hpp"
#include "tests/plugins_for_tests/sound/greeting.hpp"

namespace geodrome {
namespace {

namespace fs = std::filesystem;

Plugin<ShortestPathSolver> loaded(const std::string& name) {
  const fs::path file = fs::path(GEODROME_BINARY_DIR) / "tests" / "sound_plugins" / ("solver_" + name + ".so");
  return PluginHost().load<ShortestPathSolver>(file.string());
}

PluginDescriptor descriptor(std::uint32_t version, std::size_t size = sizeof(PluginDescriptor)) {
  PluginDescriptor plugin{};
  plugin.size = static_cast<std::uint32_t>(size);
  plugin.interface_version = version;
  plugin.build_tag = build_tag;
  return plugin;
}

std::string fault(const PluginDescriptor& plugin, AcceptedVersions accepted = {}) {
  return handshake_fault(&plugin, accepted).value_or("");
}

TEST(InterfaceVersion, EveryOneOfTheRangeIsTaken) {
  for (std::uint32_t version = 3; version <= 5; ++version)
    EXPECT_EQ(fault(descriptor(version), {.oldest = 3, .newest = 5}), "") << version;
}

TEST(InterfaceVersion, OneBesideTheRangeIsRefusedAndBothAreNamed) {
  const AcceptedVersions accepted{.oldest = 3, .newest = 5};
  EXPECT_EQ(fault(descriptor(2), accepted),
            "built for interface version 2, this host takes versions 3 to 5; rebuild the plugin against this Geodrome");
  EXPECT_EQ(fault(descriptor(6), accepted),
            "built for interface version 6, this host takes versions 3 to 5; rebuild the plugin against this Geodrome");
}

TEST(InterfaceVersion, ADescriptorMayEndBehindAnyMemberSinceTheOldest) {
  EXPECT_EQ(fault(descriptor(interface_version, smallest_descriptor)), "");
  EXPECT_EQ(fault(descriptor(interface_version)), "");
}

TEST(InterfaceVersion, ADescriptorOfAnotherSizeIsRefused) {
  for (const std::size_t size : {std::size_t{0}, smallest_descriptor - sizeof(void*), smallest_descriptor + 4,
                                 sizeof(PluginDescriptor) + sizeof(void*)})
    EXPECT_NE(fault(descriptor(interface_version, size)), "") << size;
}

TEST(InterfaceVersion, MembersBeyondTheSizeCountAsAbsent) {
  PluginDescriptor old = descriptor(oldest_interface_version, smallest_descriptor);
  old.name = "old";
  old.extension = [](const char* id) noexcept -> const void* { return id; };
  const PluginDescriptor whole = whole_descriptor(old);
  EXPECT_EQ(whole.name, old.name);
  EXPECT_EQ(whole.extension, nullptr);
}

TEST(InterfaceVersion, APluginOfTheOldestLoadsAndRuns) {
  const auto solver = loaded("test_oldest");
  const auto triangle = std::make_shared<const SurfaceMesh>(std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}},
                                                            std::vector<Triangle>{{0, 1, 2}});
  const auto values = solver.call([&](const auto& s) { return distances(s, triangle, {0, {1, 0, 0}}); });
  EXPECT_EQ(values, (std::vector<double>{0, 3, 4}));
  EXPECT_EQ(solver.extension<test::Greeting>(), nullptr);
}

TEST(Extension, AKnownOneIsFoundAndWorksOnThePluginsObject) {
  const auto solver = loaded("test_extended");
  const auto* greeting = solver.extension<test::Greeting>();
  ASSERT_NE(greeting, nullptr);
  EXPECT_EQ(solver.call([&](const auto& s) { return greeting->greet(s, 7); }), 21);
}

TEST(Extension, AnUnknownOneIsNull) {
  const auto solver = loaded("test_extended");
  ASSERT_NE(solver.find_extension, nullptr);
  EXPECT_EQ(solver.find_extension("geodrome.test.greeting/2"), nullptr);
  EXPECT_EQ(solver.find_extension(""), nullptr);
}

TEST(Extension, APluginWithoutAnyHasNone) { EXPECT_EQ(loaded("test_straight").extension<test::Greeting>(), nullptr); }

}  // namespace
}  // namespace geodrome
