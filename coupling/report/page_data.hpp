#pragma once

#include "coupling/record/press_record.hpp"
#include "coupling/report/report.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// What the pages' scripts read, as JSON text. Not-a-number becomes null; names are plain JSON
/// strings, still to be passed through escape_json_in_script.
namespace coupling {

/// A JSON string literal; bytes that are no UTF-8 become the replacement character.
std::string json_text(std::string_view text);

/// {"columns": [{"name", "unit", "values": [...]}], "stages": [{"name", "first", "last"}]}, seven
/// digits a number.
std::string record_json(PressRecord const& record);

/// Rows that a chart needs: all up to `most`; of longer records an even choice with the ends of
/// every stage, the peak force and the smallest gap.
std::vector<std::size_t> rows_to_draw(PressRecord const& record, std::size_t most = 6000);

/// {"shown", "of", "numbers": base64 of 32-bit floats x y z R overlap stress a grain [SI],
/// "component": base64}
std::string grains_json(std::span<PicturedGrain const> grains);

/// Grains that the picture needs: all up to `most`; of larger beds those at the compact's surface
/// and an even choice of the interior.
std::vector<std::size_t> grains_to_draw(std::span<PicturedGrain const> grains,
                                        std::size_t most = 250000);

/// {"grains": as grains_json, "tools": [{"name", "vertices": base64 of 32-bit floats x y z [m],
/// "triangles": base64 of 32-bit indices, "von_mises": base64 of 32-bit floats [Pa]}]}
std::string stressed_json(StressPicture const& picture);

/// Everything report.js reads.
std::string report_json(ReportData const& data);

} // namespace coupling
