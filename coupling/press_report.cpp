#include "coupling/compare/kept_observed.hpp"
#include "coupling/compare/source.hpp"
#include "coupling/elastic/stressed_surface.hpp"
#include "coupling/grain_fields.hpp"
#include "coupling/press_measures.hpp"
#include "coupling/press_output.hpp"
#include "coupling/report/report.hpp"

#include <fmt/format.h>

#include <omp.h>

namespace coupling {
namespace {

std::vector<PicturedGrain> picture(Press const& press) {
  auto const fields = grain_fields(press.world, dem::ContactStream(press.world));
  dem::Spheres const& grains = press.world.grains;
  std::vector<PicturedGrain> pictured;
  pictured.reserve(grains.size());
  for (std::size_t i = 0; i < grains.size(); ++i)
    pictured.push_back({.position = grains.position[i],
                        .radius = grains.radius[i],
                        .component = grains.material[i],
                        .mean_overlap = fields.mean_overlap[i],
                        .stress = fields.pressure[i]});
  return pictured;
}

std::vector<ToolOutline> outline_tools(Press const& press) {
  Tooling const& tooling = press.setup.tooling;
  double const radius = 0.5 * tooling.bore_diameter;
  PunchFaces const& faces = press.programme.faces();
  std::vector<ToolOutline> outlines;
  for (dem::Tool const& tool : press.world.tools) {
    if (!tool.present)
      continue;
    double const z = tool.displacement.z();
    if (tool.name == "die")
      outlines.push_back({tool.name, radius, z, z + tooling.die_height});
    if (tool.name == "upper_punch")
      outlines.push_back({tool.name, radius, z + faces.upper, z + faces.upper});
    if (tool.name == "lower_punch")
      outlines.push_back({tool.name, radius, z + faces.lower, z + faces.lower});
  }
  return outlines;
}

/// Deformable tools under the loads of the largest force, with the grains as they stood.
StressPicture picture_stress(Press const& press) {
  PeakState const& peak = press.peak;
  StressPicture picture{.grains = {}, .tools = {}, .time = peak.time};
  if (peak.force == 0.0)
    return picture;
  for (std::size_t i = 0; i < peak.position.size(); ++i)
    picture.grains.push_back({.position = peak.position[i],
                              .radius = peak.radius[i],
                              .component = peak.material[i],
                              .mean_overlap = 0.0,
                              .stress = 0.0});
  for (std::size_t t = 0; t < press.coupling.n_tools(); ++t) {
    YieldingTool const& tool = press.coupling.tool(t);
    auto surface = stressed_surface(tool, press.coupling.peak_load(t));
    for (dem::Vec3& x : surface.vertices)
      x += peak.tools[t];
    picture.tools.push_back({tool.name, std::move(surface.vertices), std::move(surface.triangles),
                             std::move(surface.von_mises)});
  }
  return picture;
}

std::vector<ProvenanceEntry> provenance(Press const& press) {
  Case const& setup = press.setup;
  return {{"program", fmt::format("presscheck {}", PRESSCHECK_VERSION)},
          {"packing seed", fmt::format("{}", setup.powder.seed)},
          {"contact laws", fmt::format("{}, {}, {}, rolling {}", setup.contacts.law.normal,
                                       setup.contacts.law.cohesion, setup.contacts.law.tangential,
                                       setup.contacts.law.rolling)},
          {"precision", setup.contacts.law.precision == dem::Precision::mixed ? "mixed" : "double"},
          {"threads", fmt::format("{} (results do not depend on it)", omp_get_max_threads())}};
}

} // namespace

void write_press_report(Press const& press, std::filesystem::path const& file) {
  ReportData data;
  data.title = press.setup.title;
  data.summary = summarise(press);
  data.record = press.record;
  data.grains = picture(press);
  for (Component const& component : press.setup.powder.components)
    data.components.push_back(component.material.name);
  auto const& stages = press.record.stages();
  data.grains_moment =
      stages.empty() ? "before the first stage"
                     : fmt::format("at t = {:.6g} s, stage {}", press.world.time, stages.back());
  data.tools = outline_tools(press);
  data.stressed = picture_stress(press);
  data.provenance = provenance(press);
  data.resolved_case = press.setup.resolved_text;
  data.observed = kept_observed(file.parent_path());
  data.comparison = beside_observed(data.summary, data.observed);
  write_report(file, data);
}

} // namespace coupling
