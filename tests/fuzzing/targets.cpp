// SPDX-License-Identifier: MIT
#include <array>

#include "tests/fuzzing/mesh_seeds.hpp"
#include "tests/fuzzing/target.hpp"

namespace geodrome::fuzzing {

// Each stands in the file of its reader.
void check_off(std::string_view input);
void check_obj(std::string_view input);
void check_ply(std::string_view input);
void check_stl(std::string_view input);
void check_xyz(std::string_view input);
void check_csv(std::string_view input);
void check_any(std::string_view input);
void check_gzip(std::string_view input);
void check_points(std::string_view input);
void check_pairs(std::string_view input);
void check_weights(std::string_view input);
void check_npy(std::string_view input);
void check_partial(std::string_view input);
void check_index(std::string_view input);
void check_pair_index(std::string_view input);
void check_descriptor(std::string_view input);
void check_vet_answer(std::string_view input);
void check_options(std::string_view input);

std::vector<std::string> gzip_seeds();
std::vector<std::string> point_seeds();
std::vector<std::string> pair_seeds();
std::vector<std::string> weight_seeds();
std::vector<std::string> npy_seeds();
std::vector<std::string> partial_seeds();
std::vector<std::string> index_seeds();
std::vector<std::string> pair_index_seeds();
std::vector<std::string> descriptor_seeds();
std::vector<std::string> vet_answer_seeds();
std::vector<std::string> option_seeds();

std::span<const Target> targets() {
  static const std::vector<Target> all{
      {"off", check_off, [] { return mesh_seeds("OFF"); }},
      {"obj", check_obj, [] { return mesh_seeds("OBJ"); }},
      {"ply", check_ply, [] { return mesh_seeds("PLY"); }},
      {"stl", check_stl, [] { return mesh_seeds("STL"); }},
      {"xyz", check_xyz, [] { return mesh_seeds("XYZ"); }},
      {"csv", check_csv, [] { return mesh_seeds("CSV"); }},
      {"any", check_any, [] { return mesh_seeds(""); }},
      {"gzip", check_gzip, gzip_seeds},
      {"points", check_points, point_seeds},
      {"pairs", check_pairs, pair_seeds},
      {"weights", check_weights, weight_seeds},
      {"npy", check_npy, npy_seeds},
      {"partial", check_partial, partial_seeds},
      {"index", check_index, index_seeds},
#ifdef GEODROME_HAS_PAIR_INDEX
      {"pair_index", check_pair_index, pair_index_seeds},
#endif
      {"descriptor", check_descriptor, descriptor_seeds},
      {"vet_answer", check_vet_answer, vet_answer_seeds},
      {"options", check_options, option_seeds},
  };
  return all;
}

}  // namespace geodrome::fuzzing
