// SPDX-License-Identifier: MIT
#include "solver_chen_han/propagation.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace geodrome::chen_han {
namespace {

/// A half-edge leaves the queue at the least distance of its windows plus this share of its length: late enough that
/// windows of all sides have come, early enough that what depends on it need not be done again.
constexpr double patience = 0.25;

/// A way is worse than another only if it is longer by this share: more than the rounding of any path, so that of two
/// equal ways none is dropped for the other.
constexpr double rounding = 1e-13;

}  // namespace

/// A face seen from one of its half-edges: start A, end B, the third corner C at (x, y).
struct Propagation::Apex {
  Index half_edge;
  const FlatSurface::Face& face;
  int a, b, c;
  double length, x, y;

  Apex(const FlatSurface& surface, Index h)
      : half_edge(h), face(surface.face_of(h)), a(h % 3), b((a + 1) % 3), c((a + 2) % 3), length(face.length[a]) {
    std::tie(x, y) = FlatSurface::apex(face, a);
  }
  Index start() const { return face.vertex[a]; }
  Index end() const { return face.vertex[b]; }
  Index vertex() const { return face.vertex[c]; }
  double left_length() const { return face.length[c]; }
  double right_length() const { return face.length[b]; }
  /// The half-edges from B to C and from C to A.
  Index right() const { return SurfaceMesh::next(half_edge); }
  Index left() const { return SurfaceMesh::previous(half_edge); }

  /// Whether window i has lines to the left or right of C.
  bool has_left(const WindowArrays& w, std::size_t i) const {
    return side_of_line(w.x[i], w.y[i], w.low[i], x, y) < 0;
  }
  bool has_right(const WindowArrays& w, std::size_t i) const {
    return side_of_line(w.x[i], w.y[i], w.high[i], x, y) > 0;
  }
};

/// How an ordered list meets the apex: windows [0, left_end) have lines to its left, [right_begin, end) to its right;
/// what is in both has lines to it. `best` of those (or no such) keeps both sides: one angle, one split.
struct Propagation::Split {
  std::size_t right_begin, left_end, best;
  bool covered() const { return right_begin < left_end; }
  std::size_t last_left() const { return covered() ? best + 1 : left_end; }
  std::size_t first_right() const { return covered() ? best : right_begin; }
};

Propagation::Propagation(const FlatSurface& surface, const Settings& settings)
    : surface_(surface),
      settings_(settings),
      lanes_(lanes(settings.simd)),
      labels_(surface.vertex_count()),
      queue_(3 * surface.face_count() + surface.vertex_count()),
      waiting_(3 * surface.face_count(), no_index),
      trimming_(lanes_) {}

void Propagation::begin(bool keep, double limit) {
  while (!queue_.empty()) {  // a run that was stopped
    const Index element = queue_.pop();
    if (element >= waiting_.size()) continue;
    for (Index b = waiting_[element]; b != no_index;) {
      const Index next = store_[b].next;
      store_.release(b);
      b = next;
    }
    waiting_[element] = no_index;
  }
  labels_.reset(keep);
  keep_ = keep;
  limit_ = limit;
  kept_.reset();
  if (keep) kept_.prepare(waiting_.size());
  watched_.clear();
  trimming_.reset();
  counts_ = {};
}

Index Propagation::source_of(Index origin) const {
  const auto vertices = static_cast<Index>(surface_.vertex_count());
  return origin < vertices ? labels_[origin].source : origin - vertices;
}

void Propagation::next() {
  const Index element = queue_.pop();
  if (element < waiting_.size())
    process(element);
  else
    emit(element - static_cast<Index>(waiting_.size()));
  counts_.trimmed = trimming_.dropped();
}

/// Carries on what waits at a half-edge, as one list: one block of each entry in their order, the others merged into it.
void Propagation::process(Index half_edge) {
  blocks_.clear();
  for (Index b = waiting_[half_edge]; b != no_index; b = store_[b].next) blocks_.push_back(b);
  waiting_[half_edge] = no_index;
  list_.clear();
  Index depth = no_index;
  for (const Entry entry : {Entry::left, Entry::apex, Entry::right}) {
    const auto found = std::find_if(blocks_.begin(), blocks_.end(), [&](Index b) { return store_[b].entry == entry; });
    if (found == blocks_.end()) continue;
    const Block& block = store_[*found];
    if (!trimming_.append(list_, block.windows(), block.count)) continue;
    depth = std::min(depth, block.depth);
    store_.release(*found);
    blocks_.erase(found);
  }
  for (const Index b : blocks_) {
    trimming_.merge(list_, store_[b].windows(), store_[b].count);
    depth = std::min(depth, store_[b].depth);
    store_.release(b);
  }
  pass(half_edge, depth);
}

/// Carries the windows of `list_` across the face of a half-edge.
void Propagation::pass(Index half_edge, Index depth) {
  const Apex apex(surface_, half_edge);
  filter(list_, apex.length, labels_.distance(apex.start()), labels_.distance(apex.end()));
  if (list_.empty()) return;
  ++counts_.passes;
  counts_.propagated += list_.size();
  counts_.longest = std::max<std::uint64_t>(counts_.longest, list_.size());
  if (keep_) {
    const Index first = kept_.keep(half_edge, list_);
    for (std::size_t i = 0; i < list_.size(); ++i) list_.arrays().parent[i] = first + static_cast<Index>(i);
  }
  if (!watched_.empty()) lower_watched(half_edge);

  if (depth >= surface_.face_count()) return;  // a shortest path crosses no face twice
  const Split split = this->split(apex);
  if (!lanes_.parted(list_.arrays(), list_.size(), apex.x, apex.y, split.right_begin, split.left_end))
    return carry_one_by_one(apex, depth + 1);
  lower_apex(apex, split);
  carry_left(apex, list_, split.last_left(), split.right_begin, depth + 1);
  carry_right(apex, list_, split.first_right(), split.left_end, depth + 1);
}

/// Windows whose lines cross beyond the half-edge, so that they do not lie to the left and right of the apex in order.
void Propagation::carry_one_by_one(const Apex& apex, Index depth) {
  const WindowArrays& w = list_.arrays();
  std::size_t best = list_.size();
  for (std::size_t i = 0; i < list_.size(); ++i) {
    const bool left = apex.has_left(w, i), right = apex.has_right(w, i), both = left && right;
    const double x = both ? w.x[i] : left ? w.high[i] : w.low[i];
    lower_apex_by(apex, i, x, way_through(w.get(i), apex.x, apex.y, labels_.distance(apex.vertex())));
    if (both && (best == list_.size() || w.to(i, apex.x, apex.y) < w.to(best, apex.x, apex.y))) best = i;
  }
  chosen_.clear();
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (apex.has_left(w, i) && !(apex.has_right(w, i) && i > best)) chosen_.push(w.get(i));
  carry_left(apex, chosen_, chosen_.size(), chosen_.size(), depth);
  chosen_.clear();
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (apex.has_right(w, i) && !(apex.has_left(w, i) && i < best)) chosen_.push(w.get(i));
  carry_right(apex, chosen_, 0, 0, depth);
}

/// The windows that have lines to the left of the apex are the first ones of an ordered list, those with lines to the
/// right the last ones, almost always.
Propagation::Split Propagation::split(const Apex& apex) {
  const WindowArrays& w = list_.arrays();
  const auto first = [&](auto&& holds) {
    std::size_t low = 0, high = list_.size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      holds(middle) ? high = middle : low = middle + 1;
    }
    return low;
  };
  Split split{};
  split.right_begin = first([&](std::size_t i) { return apex.has_right(w, i); });
  split.left_end = first([&](std::size_t i) { return !apex.has_left(w, i); });
  split.best = split.right_begin;
  for (std::size_t i = split.right_begin + 1; i < split.left_end; ++i)
    if (w.to(i, apex.x, apex.y) < w.to(split.best, apex.x, apex.y)) split.best = i;
  return split;
}

/// Lowers the apex: by the best window that has a line to it, by the ends of windows that end beside it, and along the
/// edges. A way that bends at the end of a window exists as well; it is what keeps a vertex that lies in the gap between
/// two windows, by rounding or behind a saddle too flat to count as one.
void Propagation::lower_apex(const Apex& apex, const Split& split) {
  const WindowArrays& w = list_.arrays();
  const auto bent = [&](std::size_t i, double x) {
    lower_apex_by(apex, i, x, w.at(i, x) + std::sqrt((apex.x - x) * (apex.x - x) + apex.y * apex.y));
  };
  if (split.covered()) lower_apex_by(apex, split.best, w.x[split.best], w.to(split.best, apex.x, apex.y));
  const std::size_t left = split.covered() ? split.right_begin : split.left_end;
  const std::size_t right = split.covered() ? split.left_end : split.right_begin;
  if (left > 0 && !(left < list_.size() && w.high[left - 1] == w.low[left] && split.covered()))
    bent(left - 1, w.high[left - 1]);
  if (right < list_.size() && !(right > 0 && w.high[right - 1] == w.low[right] && split.covered()))
    bent(right, w.low[right]);

  const double by_start = labels_.distance(apex.start()) + apex.left_length();
  const double by_end = labels_.distance(apex.end()) + apex.right_length();
  if (label_is_lower(apex.vertex(), by_start))
    lower(apex.vertex(), by_start, labels_[apex.start()].source, apex.left(), 0, {no_index, apex.start()});
  if (label_is_lower(apex.vertex(), by_end))
    lower(apex.vertex(), by_end, labels_[apex.end()].source, apex.left(),
          std::atan2(apex.face.sine[apex.c], apex.face.cosine[apex.c]), {no_index, apex.end()});
}

/// By window i, coming from the image, or along a line from (x, 0) if the way bends there.
void Propagation::lower_apex_by(const Apex& apex, std::size_t i, double x, double distance) {
  if (!label_is_lower(apex.vertex(), distance)) return;
  const WindowArrays& w = list_.arrays();
  double angle = 0;
  if (surface_.kind(apex.vertex()) != FlatSurface::VertexKind::smooth) {
    const double dx = x - apex.x, dy = (x == w.x[i] ? w.y[i] : 0) - apex.y;
    angle = std::max(0.0, std::atan2(apex.y * dx - apex.x * dy, -apex.x * dx - apex.y * dy));
  }
  lower(apex.vertex(), distance, source_of(w.origin[i]), apex.left(), angle, {w.parent[i], no_index});
}

void Propagation::lower(Index vertex, double distance, Index source, Index corner, double angle, const Step& step) {
  labels_.set(vertex, {distance, angle, corner, source}, step);
  if (corner == no_index || surface_.kind(vertex) != FlatSurface::VertexKind::smooth)
    queue_.push(static_cast<Index>(waiting_.size()) + vertex, distance);
}

void Propagation::lower_watched(Index half_edge) {
  const Index face = half_edge / 3;
  auto it = std::lower_bound(watched_.begin(), watched_.end(), face,
                             [](const Watched& w, Index f) { return w.at.face < f; });
  for (; it != watched_.end() && it->at.face == face; ++it) {
    const auto [px, py] = surface_.in_frame(half_edge, it->at.b);
    for (std::size_t i = 0; i < list_.size(); ++i) {
      const double way = way_through(list_.arrays().get(i), px, py, it->distance);
      if (way < it->distance) it->distance = way, it->source = source_of(list_.arrays().origin[i]);
    }
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// Across a face

/// The lines to the left of the apex, of windows [0, end) of a list; those from `clipped` on also have lines to the apex,
/// or beyond it.
void Propagation::carry_left(const Apex& apex, const WindowList& from, std::size_t end, std::size_t clipped,
                             Index depth) {
  if (end == 0) return;
  const double limit = apex.left_length();
  carry({0, apex.face.cosine[apex.a], apex.face.sine[apex.a], 0, limit, limit}, from, 0, end);
  for (std::size_t i = std::min(clipped, end); i < end; ++i) child_.arrays().high[i] = limit;
  send_children(apex.left(), limit, labels_.distance(apex.start()), labels_.distance(apex.vertex()), Entry::left,
                depth);
}

/// The lines to the right of the apex, of windows [begin, size) of a list; those before `clipped` also have lines to the
/// apex, or beyond it.
void Propagation::carry_right(const Apex& apex, const WindowList& from, std::size_t begin, std::size_t clipped,
                              Index depth) {
  if (begin == from.size()) return;
  const double limit = apex.right_length();
  carry({apex.length, apex.face.cosine[apex.b], -apex.face.sine[apex.b], limit, limit, 0}, from, begin,
        from.size() - begin);
  for (std::size_t i = begin; i < clipped; ++i) child_.arrays().low[i - begin] = 0;
  send_children(apex.right(), limit, labels_.distance(apex.vertex()), labels_.distance(apex.end()), Entry::right,
                depth);
}

void Propagation::carry(const Turn& turn, const WindowList& from, std::size_t first, std::size_t count) {
  child_.resize(count);
  lanes_.carry(from.arrays(), first, count, turn, child_.arrays());
  std::copy_n(from.arrays().sigma + first, count, child_.arrays().sigma);
  std::copy_n(from.arrays().origin + first, count, child_.arrays().origin);
  std::copy_n(from.arrays().parent + first, count, child_.arrays().parent);
}

/// Trims and filters `child_`, whose windows left the face through half-edge `edge` and are in the frame of the other
/// side, and hands on what is left of it.
void Propagation::send_children(Index edge, double length, double at_start, double at_end, Entry entry, Index depth) {
  trimming_.trim(child_, breaks_);
  if (breaks_.empty()) {
    filter(child_, length, at_start, at_end);
    deliver(edge, child_.arrays(), 0, child_.size(), entry, depth);
    return;
  }
  breaks_.push_back(static_cast<std::uint32_t>(child_.size()));
  std::size_t first = 0;
  for (const std::size_t last : breaks_) {
    deliver(edge, child_.arrays(), first, last - first, entry, depth);
    first = last;
  }
}

/// Xin and Wang's filter, and the trimming that follows from it: |image x| - x falls along the half-edge, so where the
/// way over its start is shorter at x it is shorter at everything before x too; likewise at the end.
void Propagation::filter(WindowList& list, double length, double at_start, double at_end) {
  if (!settings_.filter) return;
  const WindowArrays& w = list.arrays();
  std::size_t first = 0, last = list.size();
  const auto longer = [](double way, double other) { return way > other + rounding * way; };
  while (first < last && longer(w.at(first, w.high[first]), at_start + w.high[first])) ++first;
  while (first < last && longer(w.at(last - 1, w.low[last - 1]), at_end + (length - w.low[last - 1]))) --last;
  counts_.filtered += list.size() - (last - first);
  list.keep(first, last);
}

/// Lets windows wait at every other half-edge on an edge; they are in the frame of one that runs the other way.
void Propagation::deliver(Index edge, const WindowArrays& windows, std::size_t first, std::size_t count, Entry entry,
                          Index depth) {
  if (count == 0) return;
  const std::size_t last = first + count - 1;
  const double near = 0.5 * (windows.at(first, windows.low[first]) + windows.at(last, windows.high[last]) -
                             (windows.high[last] - windows.low[first]));
  if (near > limit_ + rounding * near) return;
  surface_.for_each_across(edge, [&](Index half_edge, bool mirrored) {
    const Index block = store_.add(count);
    Block& b = store_[block];
    b.depth = depth;
    b.entry = entry;
    copy_windows(windows, first, count, b.windows(), 0);
    const double length = surface_.length(edge);
    if (mirrored) {
      if (entry == Entry::left || entry == Entry::right) b.entry = entry == Entry::left ? Entry::right : Entry::left;
      for (std::size_t i = 0; i < count; ++i) {
        Window w = windows.get(first + i);
        w.x = length - w.x;
        std::tie(w.low, w.high) = std::pair(length - w.high, length - w.low);
        b.windows().set(count - 1 - i, w);
      }
    }
    counts_.created += count;
    b.next = waiting_[half_edge];
    waiting_[half_edge] = block;
    queue_.push(half_edge, near + patience * length);
  });
}

// ---------------------------------------------------------------------------------------------------------------------
// Sources and pseudo-sources

/// A vertex sends windows across the faces around it: a source to all sides, a saddle to where they make an angle of at
/// least pi on both sides with the way that came in.
void Propagation::emit(Index vertex) {
  const Label& label = labels_[vertex];
  if (label.distance > limit_) return;
  const auto corners = surface_.corners(vertex);
  using Kind = FlatSurface::VertexKind;
  const Kind kind = surface_.kind(vertex);
  const bool everywhere = label.corner == no_index || kind == Kind::irregular;
  if (!everywhere && kind == Kind::smooth) return;
  ++counts_.emissions;
  if (everywhere) {
    for (const Index corner : corners) emit_into(corner);
    return;
  }
  // Directions are angles counterclockwise from the first corner.
  const auto angle_at = [this](Index h) {
    return std::atan2(surface_.face_of(h).sine[h % 3], surface_.face_of(h).cosine[h % 3]);
  };
  constexpr double margin = 1e-3;  // rad: more than the error of `came`; a window too many costs little
  constexpr double half_turn = 3.14159265358979323846 - margin;
  double came = 0, total = 0;
  for (const Index h : corners) {
    if (h == label.corner) came = total + label.angle;
    total += angle_at(h);
  }
  double from = 0;
  for (const Index h : corners) {
    const double to = from + angle_at(h);
    const bool behind = to >= came + half_turn && (kind == Kind::open_saddle || from <= came + total - half_turn);
    const bool before = from <= came - half_turn && (kind == Kind::open_saddle || to >= came - total + half_turn);
    if (behind || before) emit_into(h);
    from = to;
  }
}

/// Windows from the vertex at which `corner` starts to the opposite edge, and the ways along the two edges at it.
void Propagation::emit_into(Index corner) {
  const Index opposite = SurfaceMesh::next(corner);
  const Apex apex(surface_, opposite);  // its apex is the vertex
  const Index vertex = apex.vertex();
  const Label label = labels_[vertex];
  const double by_left = label.distance + apex.left_length(), by_right = label.distance + apex.right_length();
  const auto angle = [&](int i) { return std::atan2(apex.face.sine[i], apex.face.cosine[i]); };
  if (label_is_lower(apex.start(), by_left))
    lower(apex.start(), by_left, label.source, opposite, angle(apex.a), {no_index, vertex});
  if (label_is_lower(apex.end(), by_right))
    lower(apex.end(), by_right, label.source, apex.right(), 0, {no_index, vertex});
  child_.clear();
  child_.push({apex.length - apex.x, -apex.y, label.distance, 0, apex.length, vertex, no_index});
  filter(child_, apex.length, labels_.distance(apex.end()), labels_.distance(apex.start()));
  deliver(opposite, child_.arrays(), 0, child_.size(), Entry::apex, 1);
}

void Propagation::seed(const Source& source, Index number) {
  const SurfacePoint at = surface_.inner(source.at);
  const double start = source.start;
  for (int i = 0; i < 3; ++i) {
    if (at.b[i] != 1) continue;
    const Index vertex = surface_.face(at.face).vertex[i];
    if (label_is_lower(vertex, start)) lower(vertex, start, number, no_index, 0, {});
    return;
  }
  surface_.for_each_name(at, [&](const SurfacePoint& here) { seed_face(here, source, number); });
}

/// A source in a face or on its edge: the corners, and windows to the edges that it is not on.
void Propagation::seed_face(const SurfacePoint& at, const Source& source, Index number) {
  for (int i = 0; i < 3; ++i) {
    const Apex apex(surface_, 3 * at.face + static_cast<Index>(i));
    const auto [x, y] = surface_.in_frame(apex.half_edge, at.b);
    const double distance = source.start + std::hypot(x, y);
    if (label_is_lower(apex.start(), distance))
      lower(apex.start(), distance, number, apex.half_edge, std::max(0.0, std::atan2(y, x)), {});
    if (at.b[apex.c] == 0) continue;
    child_.clear();
    child_.push({apex.length - x, -y, source.start, 0, apex.length,
                 static_cast<Index>(surface_.vertex_count()) + number, no_index});
    deliver(apex.half_edge, child_.arrays(), 0, 1, Entry::loose, 1);
  }
}

std::size_t Propagation::bytes() const {
  return labels_.bytes() + queue_.bytes() + waiting_.capacity() * sizeof(Index) + store_.bytes() + trimming_.bytes() +
         kept_.bytes() + watched_.capacity() * sizeof(Watched) + list_.bytes() + child_.bytes() + chosen_.bytes();
}

}  // namespace geodrome::chen_han
