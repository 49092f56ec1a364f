#pragma once

#include "coupling/record/csv.hpp"
#include "coupling/study/coding.hpp"
#include "coupling/study/response_surface.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

/// The seed's tables 6, 7 and 8 as observations, from the files of its case.
namespace study_seed {

using coupling::study::FactorRange;
using coupling::study::Observations;

inline FactorRange const modulus_of_table7{"E", 1375.0, 3625.0}; // [MPa]
inline FactorRange const cohesion_of_table7{"CED", 3.0, 7.0};    // [1e6 J/m^3]
inline std::vector<FactorRange> const factors_of_table7{modulus_of_table7, cohesion_of_table7};
inline std::vector<FactorRange> const factors_of_table6{
    {"E", 250.0, 2500.0}, {"CED", 1.0, 5.0}, {"D", 300.0, 500.0}}; // [MPa, 1e6 J/m^3, um]

struct SeedTable {
  Eigen::MatrixXd natural; ///< modulus [MPa], cohesion [1e6 J/m^3], diameter [um], as names say
  Eigen::VectorXd values;
};

/// @param column  "max_force [N]", "porosity [%]" or "shape_quality [1]"
inline SeedTable read(std::string const& table, std::string const& simulator,
                      std::string const& column) {
  std::string const name = "/cases/seed-mgo-alumina/observed/" + table + ".csv";
  auto const lines = coupling::split_csv(support::bytes_of(PRESSCHECK_SOURCE_DIR + name), name);
  auto const& header = lines.at(0).fields;
  auto const at = static_cast<std::size_t>(std::ranges::find(header, column) - header.begin());
  std::vector<double> rows;
  std::vector<double> values;
  for (auto const& line : lines)
    if (line.fields.at(1) == simulator) { // E1375_CED3_D300
      auto const& setup = line.fields.at(0);
      rows.push_back(std::stod(setup.substr(1, 4)));
      rows.push_back(std::stod(setup.substr(9, 1)));
      rows.push_back(std::stod(setup.substr(12)));
      values.push_back(std::stod(line.fields.at(at)));
    }
  auto const n = static_cast<Eigen::Index>(values.size());
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  return {Eigen::Map<Rows const>(rows.data(), n, 3),
          Eigen::Map<Eigen::VectorXd const>(values.data(), n)};
}

inline Observations observations(std::string const& table, std::string const& simulator,
                                 std::string const& column) {
  auto const& factors = table == "table6" ? factors_of_table6 : factors_of_table7;
  auto const seed = read(table, simulator, column);
  auto const k = static_cast<Eigen::Index>(factors.size());
  return {names_of(factors), to_coded(factors, seed.natural.leftCols(k)),
          column.substr(0, column.find(' ')), seed.values};
}

} // namespace study_seed
