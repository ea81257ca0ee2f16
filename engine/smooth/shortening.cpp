// SPDX-License-Identifier: MIT
#include "engine/smooth/shortening.hpp"

#include <algorithm>
#include <cmath>

#include "engine/smooth/piece_length.hpp"

namespace geodrome {

namespace {

/// Nodes move by 0.01 to 0.1 spacings in the mean. Where one is to move farther than this, the step is cut short:
/// beyond that its chart knows little.
constexpr double farthest_move = 1.5;

/// Where no node moves by more spacings than this, its derivatives tell where it comes to lie, which changes the length
/// by 1e-8 of it at most. Else the surface is asked, and another step follows, for the square of what is missing still
/// counts: near conjugate points, a few paths in a hundred.
constexpr double far_move = 0.25;
constexpr int most_steps = 4;

/// Lengths that differ by less than this part of them are equal but for rounding.
constexpr double rounding = 1e-13;

/// The length of a curve through every `stride`-th of the nodes.
double length_of(std::span<const SmoothPoint> nodes, std::size_t stride = 1) {
  double length = 0;
  for (std::size_t i = stride; i < nodes.size(); i += stride) length += length_between(nodes[i - stride], nodes[i]);
  return length;
}

/// What the surface may be off by along a curve.
void estimate_smooth(std::span<const SmoothPoint> points, std::span<const CurveNode> nodes, LengthError& error) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = distance(points[i - 1].position, points[i].position);
    if (length == 0) continue;
    const double spacing = (nodes[i - 1].spacing + nodes[i].spacing) / 2;
    error.add_smooth(std::max(nodes[i - 1].expected_error, nodes[i].expected_error),
                     norm(points[i].normal - points[i - 1].normal), length / spacing);
  }
}

/// The angle between the normals of two faces.
double turn_between(const SurfaceMesh& mesh, Index a, Index b) {
  const auto normal = [&](Index face) {
    const auto [p, q, r] = mesh.corners(face);
    return cross(q - p, r - p);
  };
  const Vec3 m = normal(a), n = normal(b);
  return a == b ? 0 : std::atan2(norm(cross(m, n)), dot(m, n));
}

}  // namespace

template <class Value>
std::span<Value> Shortening::part(std::vector<Value>& all, const Section& section) {
  return std::span(all).subspan(section.first, section.end - section.first);
}

void Shortening::start_batch() {
  sections_.clear(), lengths_.clear(), nodes_.clear(), flat_.clear();
  done_ = false;
}

void Shortening::add(std::span<const SurfacePoint> path) {
  if (done_) start_batch();
  charts_.cut(path, pieces_);
  SmoothLength& result = lengths_.emplace_back();
  for (auto begin = pieces_.begin(), end = begin; begin != pieces_.end(); begin = end) {
    const bool smooth = charts_.trusts(begin->face);
    double length = 0;
    for (; end != pieces_.end() && charts_.trusts(end->face) == smooth; ++end) length += end->length;
    result.flat += length;
    Section section{lengths_.size() - 1, smooth, smooth ? nodes_.size() : flat_.size(), 0};
    if (smooth) {
      result.smooth += length;
      place_nodes(charts_, {begin, end}, nodes_);
    } else {
      result.length += length;
      flat_.push_back({begin->face, begin->from});
      for (auto piece = begin; piece != end; ++piece) flat_.push_back({piece->face, piece->to});
    }
    section.end = smooth ? nodes_.size() : flat_.size();
    sections_.push_back(section);
  }
  estimate_flat(result.error);
}

/// What the flat pieces of a path may be off by: half of each with the turn at either end.
void Shortening::estimate_flat(LengthError& error) const {
  for (std::size_t i = 1; i < pieces_.size(); ++i) {
    const FlatPiece &p = pieces_[i - 1], &q = pieces_[i];
    const double flat = (charts_.trusts(p.face) ? 0 : p.length) + (charts_.trusts(q.face) ? 0 : q.length);
    if (flat > 0) error.add_flat(flat / 2, turn_between(charts_.mesh(), p.face, q.face));
  }
}

/// Asks for all nodes of some sections.
void Shortening::ask(std::span<Section* const> sections, std::vector<SmoothPoint>& answers) {
  places_.clear();
  for (const Section* section : sections)
    for (const CurveNode& node : part(nodes_, *section)) places_.push_back(node.place);
  answers_.resize(places_.size());
  charts_.surface().evaluate(places_, answers_);
  auto answer = answers_.begin();
  for (const Section* section : sections)
    for (SmoothPoint& point : part(answers, *section)) point = *answer++;
}

/// Moves the nodes of a section by their moves, `times` 1, or back, `times` -1.
void Shortening::shift(const Section& section, double times) {
  for (std::size_t i = section.first; i < section.end; ++i)
    for (int k = 0; k < 3; ++k) nodes_[i].place.at.b[k] += times * moves_[i] * nodes_[i].across[k];
}

/// Moves the nodes by a step. Returns false, with nothing moved, if there is none.
bool Shortening::step(Section& section) {
  const std::span moves = part(moves_, section);
  if (!newton_.find(part(at_, section), moves)) return lengths_[section.path].moved = false;
  double farthest = 0;
  for (std::size_t i = 0; i < moves.size(); ++i)
    farthest = std::max(farthest, std::abs(moves[i]) / nodes_[section.first + i].spacing);
  if (!(farthest < infinity)) return lengths_[section.path].moved = false;
  if (farthest > farthest_move)
    for (double& move : moves) move *= farthest_move / farthest;
  shift(section, 1);
  section.farthest = farthest;
  return true;
}

/// Finds where the nodes of some sections come to lie by their step.
void Shortening::find_next() {
  const auto near =
      std::ranges::partition(moving_, [](const Section* section) { return section->farthest > far_move; });
  ask({moving_.begin(), near.begin()}, next_);
  for (const Section* section : near)
    for (std::size_t i = section->first; i < section->end; ++i) next_[i] = moved(at_[i], moves_[i]);
}

/// Keeps a step if it made the curve shorter, else takes it back. Returns true if another one is worth its while.
bool Shortening::accept(Section& section) {
  const double length = length_of(part(next_, section));
  if (length <= section.length * (1 + rounding)) {
    section.length = length;
    std::ranges::copy(part(next_, section), part(at_, section).begin());
    return section.farthest > far_move;
  }
  shift(section, -1);
  return lengths_[section.path].moved = false;
}

void Shortening::measure(const Section& section) {
  const std::span nodes = part(at_, section);
  const double finer = left_by_halving(section.length, length_of(nodes, 2));
  SmoothLength& result = lengths_[section.path];
  result.length += section.length + finer;
  result.error.add_extrapolation(finer);
  estimate_smooth(nodes, part(nodes_, section), result.error);
}

Vec3 Shortening::position(const Section& section, std::size_t i) const {
  return section.smooth ? at_[i].position : charts_.mesh().position(flat_[i]);
}

/// No path is shorter than the straight line between its ends, whatever the formula says of pieces that are too long.
void Shortening::bound_from_below() {
  for (std::size_t i = 0, last = 0; i < sections_.size(); i = last + 1) {
    for (last = i; last + 1 < sections_.size() && sections_[last + 1].path == sections_[i].path;) ++last;
    double& length = lengths_[sections_[i].path].length;
    const Vec3 begin = position(sections_[i], sections_[i].first),
               end = position(sections_[last], sections_[last].end - 1);
    length = std::max(length, distance(begin, end));
  }
}

std::span<const SmoothLength> Shortening::run() {
  if (done_) start_batch();
  done_ = true;
  at_.resize(nodes_.size()), next_.resize(nodes_.size()), moves_.resize(nodes_.size());
  moving_.clear();
  for (Section& section : sections_)
    if (section.smooth) moving_.push_back(&section);
  ask(moving_, at_);
  for (Section* section : moving_) section->length = length_of(part(at_, *section));
  for (int k = 0; k < most_steps && !moving_.empty(); ++k) {
    std::erase_if(moving_, [&](Section* section) { return !step(*section); });
    find_next();
    std::erase_if(moving_, [&](Section* section) { return !accept(*section); });
  }
  for (const Section& section : sections_)
    if (section.smooth) measure(section);
  bound_from_below();
  return lengths_;
}

std::optional<Shortening::SmoothCurve> Shortening::smooth_curve(std::size_t path) {
  const auto sections = std::ranges::equal_range(sections_, path, {}, &Section::path);
  if (sections.size() != 1 || !sections.front().smooth || !lengths_[path].moved) return std::nullopt;
  return SmoothCurve{part(nodes_, sections.front()), part(at_, sections.front())};
}

void Shortening::curve(std::size_t path, std::vector<SurfacePoint>& points, std::vector<Vec3>& positions) {
  const auto [begin, end] = std::ranges::equal_range(sections_, path, {}, &Section::path);
  for (auto section = begin; section != end; ++section) {
    Section* const one = &*section;
    if (section->smooth) ask({&one, 1}, at_);  // where derivatives told before where a node lies
    for (std::size_t i = section->first; i < section->end; ++i) {
      points.push_back(section->smooth ? nodes_[i].place.at : flat_[i]);
      positions.push_back(position(*section, i));
    }
  }
}

}  // namespace geodrome
