// SPDX-License-Identifier: MIT
#include "geodrome/engine/plugin_host.hpp"

#include <elf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <ostream>
#include <thread>

#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/tangent_estimator.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/temporary_folder.hpp"

namespace geodrome {
namespace {

namespace fs = std::filesystem;
using testing::Environment;
using testing::TemporaryFolder;

const fs::path plugins_for_tests = fs::path(GEODROME_BINARY_DIR) / "tests";
const fs::path bad_plugins = plugins_for_tests / "bad_plugins", sound_plugins = plugins_for_tests / "sound_plugins";

fs::path plugin_file(const std::string& name) {
  return (name.starts_with("bad_") ? bad_plugins : sound_plugins) / ("solver_" + name + ".so");
}

/// The size of a library without what its loader does not read: debugging information may be more than half of it.
std::uint64_t loaded_size(const fs::path& library) {
  std::ifstream file(library, std::ios::binary);
  Elf64_Ehdr header{};
  file.read(reinterpret_cast<char*>(&header), sizeof header);
  std::uint64_t size = 0;
  file.seekg(static_cast<std::streamoff>(header.e_phoff));
  for (int i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    file.read(reinterpret_cast<char*>(&segment), sizeof segment);
    if (segment.p_type == PT_LOAD) size = std::max<std::uint64_t>(size, segment.p_offset + segment.p_filesz);
  }
  return size;
}

/// What the host says of a file; empty if it accepts it.
std::string refusal(const fs::path& file) {
  try {
    PluginHost().inspect(file);
  } catch (const PluginError& error) {
    return error.what();
  }
  return {};
}

template <class Error>
std::string message_of_load(const PluginHost& host, const std::string& selection) {
  try {
    host.load<ShortestPathSolver>(selection);
  } catch (const Error& error) {
    return error.what();
  }
  return "(no error of that kind)";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

#define EXPECT_CONTAINS(text, part) EXPECT_PRED2(contains, text, part)

MeshPtr right_triangle() {
  return std::make_shared<const SurfaceMesh>(std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}},
                                             std::vector<Triangle>{{0, 1, 2}});
}

struct Refused {
  const char *name, *reason;
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.name; }

class RefusedPlugin : public ::testing::TestWithParam<Refused> {};

TEST_P(RefusedPlugin, IsToldByFileAndReason) {
  const Environment limit("GEODROME_VET_TIMEOUT", "5");
  const std::string message = refusal(plugin_file(GetParam().name));
  EXPECT_CONTAINS(message, plugin_file(GetParam().name).string());
  EXPECT_CONTAINS(message, GetParam().reason);
}

INSTANTIATE_TEST_SUITE_P(
    PluginHost, RefusedPlugin,
    ::testing::Values(
        Refused{"bad_version", "built for interface version 4711, this host takes version 2; rebuild the plugin"},
        Refused{"bad_old_version", "built for interface version 1, this host takes version 2; rebuild the plugin"},
        Refused{"bad_size", "its descriptor has 96 bytes, this host's has 112"},
        Refused{"bad_extension", "it offers an extension that does not exist"},
        Refused{"bad_build_tag", "built as 'libother debug float', this host is built as 'libstdc++"},
        Refused{"bad_no_entry", "no entry geodrome_plugin"},
        Refused{"bad_throws_at_load", "threw while being loaded: the licence server is down"},
        Refused{"bad_crashes_at_load", "crashed with SIGSEGV while being loaded"},
        Refused{"bad_aborts_at_load",
                "crashed with SIGABRT while being loaded (it said: bad_aborts_at_load: lookup table is corrupt)"},
        Refused{"bad_exits_at_load", "ended the process with status 0 while being loaded"},
        Refused{"bad_duplicate_option", "option 'k' is declared twice"},
        Refused{"bad_default", "option 'k': '30' is not a whole number from 1 to 9"},
        Refused{"bad_comma", "option 'delta': a value with a comma cannot be written, since a comma ends an option"},
        Refused{"bad_stage", "its stage 'teleporter' is none of tangent, control, decimator, reconstructor, solver"},
        Refused{"bad_name", "its name 'Bad Name' is not made of a-z, 0-9 and _"},
        Refused{"bad_summary", "its summary is missing"},
        Refused{"bad_needs", "it needs something this host does not know"},
        Refused{"bad_factor", "its factor 0.5 is below 1"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(PluginHost, RefusesAPluginThatHangs) {
  const Environment limit("GEODROME_VET_TIMEOUT", "0.5");
  EXPECT_CONTAINS(refusal(plugin_file("bad_hangs_at_load")), "did not finish loading within 0.5 s");
}

TEST(PluginHost, RefusesATextFile) {
  const TemporaryFolder folder;
  std::ofstream(folder / "solver_text.so") << "not a library\n";
  EXPECT_CONTAINS(refusal(folder / "solver_text.so"), "cannot be loaded");
}

TEST(PluginHost, RefusesAnEmptyFile) {
  const TemporaryFolder folder;
  std::ofstream(folder / "solver_empty.so").close();
  EXPECT_CONTAINS(refusal(folder / "solver_empty.so"), "file too short");
}

TEST(PluginHost, RefusesATruncatedLibraryAtAnyLength) {
  const TemporaryFolder folder;
  const std::uint64_t whole = loaded_size(plugin_file("test_straight"));
  for (const auto size : {whole / 64, whole / 4, whole / 2}) {
    const fs::path file = folder / ("solver_cut_" + std::to_string(size) + ".so");
    fs::copy_file(plugin_file("test_straight"), file);
    fs::resize_file(file, size);
    EXPECT_CONTAINS(refusal(file), file.string() + " is refused");
  }
}

TEST(PluginHost, SaysThatAFileIsNotThere) {
  EXPECT_CONTAINS(message_of_load<OptionError>(PluginHost(), "/nowhere/solver_x.so"), "is not there");
}

TEST(PluginHost, TellsTheLoadersOwnReasonOnly) {
  const TemporaryFolder folder;
  std::ofstream(folder / "solver_text.so") << "no library";
  const std::string reason = refusal(folder / "solver_text.so");
  EXPECT_CONTAINS(reason, "file too short");
  EXPECT_EQ(reason.find("boost"), std::string::npos) << reason;
}

TEST(PluginHost, ListSurvivesAllBadPluginsTogether) {
  const Environment limit("GEODROME_VET_TIMEOUT", "3");
  const PluginListing listing = PluginHost({bad_plugins, sound_plugins}).list();
  const auto offers = [&](const char* name) {
    return std::any_of(listing.usable.begin(), listing.usable.end(), [&](const auto& p) { return p.name == name; });
  };
  EXPECT_TRUE(offers("test_straight"));
  for (const PluginInfo& plugin : listing.usable)
    EXPECT_FALSE(contains(plugin.name, "at_load")) << plugin.file << " was not refused";
  EXPECT_GE(listing.refused.size(), 15u);
}

TEST(PluginHost, WhatAPluginPrintsDoesNotPassForTheAnswer) {
  EXPECT_EQ(PluginHost().inspect(plugin_file("test_noisy")).name, "test_noisy");
}

TEST(PluginHost, InspectTellsAllThatTheDescriptorSays) {
  const PluginInfo plugin = PluginHost().inspect(plugin_file("test_straight"));
  EXPECT_EQ(plugin.full_name(), "solver_test_straight");
  EXPECT_EQ(plugin.summary, "straight through space");
  EXPECT_EQ(plugin.licence, "MIT");
  EXPECT_EQ(plugin.needs, Needs::manifold);
  EXPECT_EQ(plugin.provides, Provides::start_distances | Provides::face_sources | Provides::never_shorter)
      << "the last follows from the factor";
  EXPECT_EQ(plugin.default_factor, 1.5);
  ASSERT_EQ(plugin.options.size(), 4u);
  EXPECT_EQ(plugin.options[1].maximum, std::numeric_limits<double>::infinity());
  EXPECT_EQ(plugin.options[2].choices, "calm|wild");
}

TEST(PluginHost, LoadsByNameByFullNameAndByFile) {
  const PluginHost host({sound_plugins});
  for (const std::string& selection :
       {std::string("test_straight"), std::string("solver_test_straight"), plugin_file("test_straight").string()}) {
    const auto solver = host.load<ShortestPathSolver>(selection);
    const auto values = solver.call([](const auto& s) { return distances(s, right_triangle(), {0, {1, 0, 0}}); });
    EXPECT_EQ(values, (std::vector<double>{0, 3, 4})) << selection;
  }
}

TEST(PluginHost, OptionsReachThePluginAndItsFactor) {
  const PluginHost host({sound_plugins});
  EXPECT_EQ(host.load<ShortestPathSolver>("test_straight:slack=2,mood=wild").factor, 3);
  const auto by_file = host.load<ShortestPathSolver>(plugin_file("test_straight").string() + ":slack=4");
  EXPECT_EQ(by_file.options.text("mood"), "calm");
  EXPECT_EQ(by_file.factor, 5);
}

TEST(PluginHost, AWrongOptionNamesPluginAndRange) {
  const std::string message = message_of_load<OptionError>(PluginHost({sound_plugins}), "test_straight:rounds=10");
  EXPECT_CONTAINS(message, "solver_test_straight: option 'rounds': '10' is not a whole number from 1 to 9");
}

TEST(PluginHost, AnOptionErrorOfThePluginStaysOne) {
  const std::string message = message_of_load<OptionError>(PluginHost({sound_plugins}), "test_straight:rounds=7");
  EXPECT_CONTAINS(message, "solver_test_straight: 7 rounds are too many");
}

TEST(PluginHost, AnUnknownNameListsValidOnesAndFolders) {
  const TemporaryFolder folder;
  fs::copy_file(plugin_file("test_straight"), folder / "solver_test_straight.so");
  const std::string message = message_of_load<OptionError>(PluginHost({folder.path()}), "no_such");
  EXPECT_CONTAINS(message, "there is no solver plugin 'no_such'");
  EXPECT_CONTAINS(message, "test_straight");
  EXPECT_CONTAINS(message, folder.path().string());
}

TEST(PluginHost, AnotherStageIsRefused) {
  EXPECT_THROW(PluginHost().load<TangentEstimator>(plugin_file("test_straight").string()), OptionError);
}

TEST(PluginHost, AConstructorThatThrowsNamesThePlugin) {
  const std::string message = message_of_load<PluginError>(PluginHost({bad_plugins}), "bad_throws_in_create");
  EXPECT_CONTAINS(message, "solver_bad_throws_in_create: cannot be set up: table of weights not found");
}

TEST(PluginHost, NoObjectWithoutAReasonIsAnError) {
  const std::string message = message_of_load<PluginError>(PluginHost({bad_plugins}), "bad_null_from_create");
  EXPECT_CONTAINS(message, "solver_bad_null_from_create: cannot be set up: it gives no object and no reason");
}

TEST(PluginHost, ARunVetsOnlyWhatItChose) {
  const Environment limit("GEODROME_VET_TIMEOUT", "60");  // the one that hangs is in the same folder
  const auto begin = std::chrono::steady_clock::now();
  PluginHost({sound_plugins}).load<ShortestPathSolver>("test_straight");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(50));
}

/// Two folders, each with the same plugin: which of them is taken?
class SearchOrder : public ::testing::Test {
 protected:
  static void put(const TemporaryFolder& folder, const char* as = "solver_test_straight.so") {
    fs::copy_file(plugin_file("test_straight"), folder / as);
  }
  static fs::path taken(const PluginHost& host) { return host.load<ShortestPathSolver>("test_straight").info.file; }
  const TemporaryFolder first_, second_;
};

TEST_F(SearchOrder, ExtraFoldersGoBeforeTheEnvironment) {
  put(first_), put(second_);
  const Environment path("GEODROME_PLUGIN_PATH", first_.path().string());
  EXPECT_EQ(taken(PluginHost({second_.path()})), second_ / "solver_test_straight.so");
}

TEST_F(SearchOrder, EarlierFoldersOfTheEnvironmentGoBeforeLaterOnes) {
  put(first_), put(second_);
  const Environment path("GEODROME_PLUGIN_PATH", second_.path().string() + "::" + first_.path().string());
  EXPECT_EQ(taken(PluginHost()), second_ / "solver_test_straight.so");
}

TEST_F(SearchOrder, AFileOfAnotherNameIsFoundToo) {
  put(first_, "renamed.so");
  EXPECT_EQ(taken(PluginHost({first_.path()})), first_ / "renamed.so");
}

TEST_F(SearchOrder, ListShowsTheOneThatLoadTakesAndWhatItHides) {
  put(first_, "a.so"), put(second_);
  const PluginHost host({first_.path(), second_.path()});
  const PluginListing listing = host.list();
  const auto shown = std::find_if(listing.usable.begin(), listing.usable.end(),
                                  [](const PluginInfo& plugin) { return plugin.name == "test_straight"; });
  ASSERT_NE(shown, listing.usable.end());
  EXPECT_EQ(shown->file, taken(host));
  ASSERT_EQ(listing.refused.size(), 1u);
  EXPECT_CONTAINS(listing.refused[0].reason, "hidden by " + (second_ / "solver_test_straight.so").string());
}

TEST_F(SearchOrder, TheWorkingDirectoryIsNotSearched) {
  put(first_);
  const fs::path before = fs::current_path();
  fs::current_path(first_.path());
  const Environment path("GEODROME_PLUGIN_PATH", ":");
  EXPECT_THROW(taken(PluginHost()), OptionError);
  fs::current_path(before);
}

TEST_F(SearchOrder, TheEnginesOwnFolderIsLast) {
  const PluginHost host({first_.path()});
  EXPECT_EQ(host.folders().back(), fs::canonical(fs::path(GEODROME_BINARY_DIR) / "lib") / "geodrome");
}

TEST_F(SearchOrder, AnExtraFolderThatIsNotThereIsAnError) {
  EXPECT_THROW(PluginHost({first_ / "missing"}), OptionError);
}

TEST(PluginHost, AWrongTimeLimitIsAnOptionError) {
  for (const char* wrong : {"", "soon", "0", "-1", "3601", "nan", "5 s", "5,", "1,5", "0x10"}) {
    const Environment limit("GEODROME_VET_TIMEOUT", wrong);
    EXPECT_THROW(PluginHost().inspect(plugin_file("test_straight")), OptionError) << wrong;
  }
}

TEST(PluginHost, ThreadsMayLoadTheSamePluginAtOnce) {
  const PluginHost host({sound_plugins});
  std::vector<std::thread> threads;
  std::atomic<int> loaded = 0;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] { loaded += host.load<ShortestPathSolver>("test_straight").object != nullptr; });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(loaded, 4);
}

}  // namespace
}  // namespace geodrome
