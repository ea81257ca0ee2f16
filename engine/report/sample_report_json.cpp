// SPDX-License-Identifier: MIT
#include <cmath>

#include "engine/report/sample_report.hpp"

namespace geodrome {

namespace {

using geodrome::to_json;  // the overloads below would hide them

Json or_null(double value) { return std::isnan(value) ? Json(nullptr) : to_json(value); }

Json to_json(const Vec3& p) { return Json::array({p.x, p.y, p.z}); }

Json sample_json(const SampleReport& report) {
  const SampleFacts& f = report.facts;
  Json json{{"rows", f.rows},     {"merged", f.merged},   {"nonfinite", f.nonfinite},
            {"points", f.points}, {"kept", f.kept},       {"unbounded", f.unbounded},
            {"capped", f.capped}, {"dropped", f.dropped}, {"sigma", or_null(f.sigma)}};
  json["psi_smallest"] = or_null(f.psi_smallest), json["psi_largest"] = or_null(f.psi_largest);
  Json missing = Json::object();
  for (const auto& [name, figure] : report.figures) {
    if (name != "sigma") json[name] = or_null(figure.value);
    if (!figure.is_measured()) missing[name] = figure.by.empty() ? "its stage did not run" : figure.by;
  }
  json["not_measured"] = missing;
  json["epsilon_at_least"] = or_null(report.epsilon);
  json["points_for_the_paper"] = or_null(report.points_for_the_paper);
  json["points_for_practice"] = or_null(report.points_for_practice);
  if (!report.distance) return json;
  const SurfaceDistance& d = *report.distance;
  const auto relative = [&](double length) { return or_null(length / report.diagonal); };
  json["distance_from_surface"] = {{"largest", d.largest},
                                   {"root_mean_square", d.root_mean_square},
                                   {"largest_over_diagonal", relative(d.largest)},
                                   {"root_mean_square_over_diagonal", relative(d.root_mean_square)},
                                   {"farthest_row", d.farthest_row == no_index ? Json(nullptr) : Json(d.farthest_row)}};
  return json;
}

Json part_json(const SurfacePart& part, bool taken) {
  Json json{{"taken", taken},
            {"points", part.points},
            {"of", part.sample},
            {"share", part.share()},
            {"spacing", part.spacing},
            {"set_aside",
             {{"no_surface", part.no_surface}, {"other_pieces", part.other_pieces}, {"off_surface", part.off_surface}}},
            {"faces_left_out", part.faces_left_out}};
  json["row"] = part.row == no_index ? Json(nullptr) : Json(part.row);
  return json;
}

Json to_json(const Claim& claim) {
  Json json{{"code", claim.code},     {"claim", claim.name},
            {"source", claim.source}, {"measured", or_null(claim.measured)},
            {"bound", claim.bound},   {"holds", claim.is_measured() ? Json(claim.holds()) : Json(nullptr)}};
  if (!claim.is_measured()) json["not_measured"] = claim.not_measured;
  return json;
}

Json to_json(const GuaranteeVerdict& verdict) {
  Json claims = Json::array();
  for (const Claim& claim : verdict.claims) claims.push_back(to_json(claim));
  const char* note =
      "epsilon <= 1/22 concerns the unknown surface: a sample can refute the guarantee, never confirm it";
  return {{"verdict", verdict.void_because.empty() ? "not refuted" : "void"},
          {"because", verdict.void_because},
          {"claims", claims},
          {"note", note}};
}

Json to_json(const Practice& practice) {
  return {{"verdict", word(practice.verdict)}, {"because", practice.because}, {"note", practice_note}};
}

Json to_json(const WorstPlace& place) {
  Json troubles = Json::array();
  for (const Trouble& t : place.troubles) {
    Json trouble{{"code", t.code}, {"what", t.what}, {"fails", t.fails}};
    if (t.has_bound)
      trouble["measured"] = to_json(t.measured), trouble["bound"] = t.bound, trouble["source"] = t.source;
    trouble["remedy"] = t.remedy;
    troubles.push_back(trouble);
  }
  return {{"row", place.row}, {"position", to_json(place.position)}, {"troubles", troubles}};
}

}  // namespace

Json to_json(const SurfaceFacts& facts) {
  Json json{{"vertices", facts.vertices},     {"faces", facts.faces},
            {"components", facts.components}, {"boundary_loops", facts.boundary_loops},
            {"manifold", facts.manifold},     {"oriented", facts.oriented},
            {"closed", facts.closed},         {"euler_number", facts.euler_number}};
  json["genus"] = facts.genus ? Json(*facts.genus) : Json(nullptr);
  json["smallest_angle"] = to_json(facts.smallest_angle);
  json["largest_edge_ratio"] = to_json(facts.largest_edge_ratio);
  json["largest_degree"] = facts.largest_degree;
  return json;
}

Json to_json(const SampleReport& report) {
  Json json{{"sample", sample_json(report)}};
  if (report.surface) json["surface"] = to_json(*report.surface);
  if (const auto& empty = report.empty_place)
    json["empty_place"] = {
        {"radius", empty->radius}, {"points_missing", empty->missing}, {"nearest_row", empty->nearest_row}};
  if (report.torn) json["torn_between_rows"] = {report.torn->first, report.torn->second};
  if (report.part) json["part"] = part_json(*report.part, report.surface.has_value());
  json["guarantee_of_the_paper"] = to_json(report.guarantee);
  json["practice"] = to_json(report.practice);
  json["worst_places"] = Json::array();
  for (const WorstPlace& place : report.worst) json["worst_places"].push_back(to_json(place));
  json["refused"] = report.refusal.has_value();
  if (report.refusal)
    json["refusal"] = {
        {"plugin", report.refusal->plugin}, {"reason", report.refusal->reason}, {"remedy", report.refusal->remedy}};
  return json;
}

}  // namespace geodrome
