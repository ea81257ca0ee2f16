// SPDX-License-Identifier: MIT
#include "tests/fuzzing/mesh_promises.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/formats/bytes.hpp"
#include "engine/formats/text_output.hpp"
#include "geodrome/surface.hpp"
#include "tests/fuzzing/target.hpp"

namespace geodrome::fuzzing {
namespace {

void demand_fit_to_show(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    demand(!finding.code.empty() && !finding.message.empty(), "a finding has a code and a message");
    demand(finding.elements.size() <= finding.count, "a finding counts the elements that it names");
    fuzzing::demand_fit_to_show(finding.message);
    fuzzing::demand_fit_to_show(finding.remedy.text);
  }
}

bool same_number(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

bool same_place(const Vec3& a, const Vec3& b) {
  return same_number(a.x, b.x) && same_number(a.y, b.y) && same_number(a.z, b.z);
}

void demand_sound_rows(const Input& input) {
  demand(!input.positions.empty(), "an input holds a point");
  for (const Vec3& p : input.positions) demand(is_finite(p), "positions are finite");
  demand(input.element_of_row.size() == input.facts.rows, "every row has a place");
  std::size_t dropped = 0;
  for (const Index element : input.element_of_row) {
    demand(element == no_index || element < input.positions.size(), "places of rows are in range");
    dropped += element == no_index;
  }
  demand(dropped == input.facts.dropped, "dropped rows are counted");
  demand(input.positions.size() + input.facts.merged + dropped == input.facts.rows, "no row is lost");
}

void demand_sound_faces(const Input& input) {
  demand((input.kind == InputKind::mesh) == !input.triangles.empty(), "a mesh has faces, points have none");
  demand(input.face_of_triangle.size() == input.triangles.size(), "every triangle is of a face");
  demand(input.weights.empty() || input.weights.size() == input.triangles.size(), "every triangle has its weight");
  for (const Index face : input.face_of_triangle) demand(face < input.facts.faces_in_file, "faces are in range");
  for (const double weight : input.weights)
    demand(weight >= 1e-100 && weight <= 1e100, "weights are positive and in range");
  if (input.kind == InputKind::points) return;
  const SurfaceMesh mesh(input.positions, input.triangles, input.weights);  // throws for indices out of range
  demand(mesh.manifold() == input.facts.manifold, "the input and its surface agree on what is manifold");
  demand(mesh.closed() == (input.facts.boundary_edges == 0), "the input and its surface agree on the boundary");
  demand(!mesh.oriented() || input.facts.orientable, "an oriented surface is orientable");
}

template <class Number>
void append(std::string& bytes, Number number, bool big) {
  const std::size_t at = bytes.size();
  append_little_endian(bytes, number);
  if (big) std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end());
}

std::string text_body(const input::Soup& soup) {
  std::string text;
  for (const Vec3& p : soup.positions) append_point(text, "", p);
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    text += std::to_string(soup.face(f).size());
    for (const Index corner : soup.face(f)) text += ' ' + std::to_string(corner);
    text += '\n';
  }
  return text;
}

std::string binary_body(const input::Soup& soup, bool big) {
  std::string bytes;
  for (const Vec3& p : soup.positions)
    for (const double coordinate : {p.x, p.y, p.z}) append(bytes, coordinate, big);
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    append(bytes, static_cast<std::uint32_t>(soup.face(f).size()), big);
    for (const Index corner : soup.face(f)) append(bytes, corner, big);
  }
  return bytes;
}

}  // namespace

void demand_sound(const input::Soup& soup, std::size_t bytes) {
  // A byte of a strip of triangles stands for a whole one.
  demand(soup.positions.size() <= bytes && soup.corners.size() <= 3 * bytes && soup.face_count() <= bytes,
         "no more elements than bytes");
  for (const Index corner : soup.corners) demand(corner < soup.positions.size(), "corners are in range");
  demand(std::ranges::is_sorted(soup.face_end), "faces follow one another");
  demand(soup.corners.size() == (soup.face_end.empty() ? 0 : soup.face_end.back()), "every corner is of a face");
  demand(soup.face_weights.empty() || soup.face_weights.size() == soup.face_count(), "every face has its weight");
  demand_fit_to_show(soup.findings);
}

void demand_sound(const Input& input) {
  demand_sound_rows(input);
  demand_sound_faces(input);
  demand(std::isfinite(input.facts.bounding_box_diagonal), "the diagonal is finite");
  demand_fit_to_show(input.findings);
}

bool same(const input::Soup& a, const input::Soup& b) {
  return std::ranges::equal(a.positions, b.positions, same_place) && a.corners == b.corners &&
         a.face_end == b.face_end && std::ranges::equal(a.face_weights, b.face_weights, same_number);
}

void demand_same_mesh(const Input& a, const Input& b) {
  const InputFacts &x = a.facts, &y = b.facts;
  demand(std::ranges::equal(a.positions, b.positions, same_place), "positions come back");
  demand(a.triangles == b.triangles && a.weights == b.weights, "faces and weights come back");
  demand(x.components == y.components && x.boundary_loops == y.boundary_loops && x.genus == y.genus &&
             x.euler_number == y.euler_number && x.manifold == y.manifold && x.oriented == y.oriented &&
             x.orientable == y.orientable && x.zero_area_faces == y.zero_area_faces &&
             x.isolated_vertices == y.isolated_vertices && x.bounding_box_diagonal == y.bounding_box_diagonal,
         "the same mesh has the same facts");
}

std::string ply_of(const input::Soup& soup, PlyText encoding) {
  const char* const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  std::string text = std::string("ply\nformat ") + names[static_cast<int>(encoding)] + " 1.0\nelement vertex " +
                     std::to_string(soup.positions.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                     std::to_string(soup.face_count()) + "\nproperty list uint uint vertex_indices\nend_header\n";
  if (encoding == PlyText::ascii) return text + text_body(soup);
  return text + binary_body(soup, encoding == PlyText::big_endian);
}

}  // namespace geodrome::fuzzing
