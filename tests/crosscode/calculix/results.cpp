#include "tests/crosscode/calculix/results.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace crosscode {

namespace {
enum class Block { none, displacements, stresses, coordinates };

Block block_of(std::string const& title) {
  if (title.find("displacements") != std::string::npos)
    return Block::displacements;
  if (title.find("stresses") != std::string::npos)
    return Block::stresses;
  if (title.find("global coordinates") != std::string::npos)
    return Block::coordinates;
  throw std::runtime_error("CalculiX prints a block that was not asked for: " + title);
}

Eigen::Matrix3d symmetric(std::istream& row) { // xx, yy, zz, xy, xz, yz
  Eigen::Matrix3d s;
  row >> s(0, 0) >> s(1, 1) >> s(2, 2) >> s(0, 1) >> s(0, 2) >> s(1, 2);
  s.triangularView<Eigen::StrictlyLower>() = s.transpose();
  return s;
}
} // namespace

CalculixResults read_results(std::filesystem::path const& file) {
  std::ifstream stream(file);
  CalculixResults results;
  std::size_t n_places = 0, n_stresses = 0;
  Block block = Block::none;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("time") != std::string::npos) {
      block = block_of(line);
      continue;
    }
    std::istringstream row(line);
    unsigned number = 0, point = 0;
    if (!(row >> number))
      continue;
    Eigen::Vector3d x;
    if (block == Block::displacements && row >> x[0] >> x[1] >> x[2])
      results.displacement[number] = x;
    if (block == Block::stresses && row >> point) {
      results.stress[number].emplace_back(Eigen::Vector3d::Zero(), symmetric(row));
      n_stresses += static_cast<bool>(row);
    }
    if (block == Block::coordinates && row >> point >> x[0] >> x[1] >> x[2]) {
      results.stress[number].at(point - 1).first = x;
      ++n_places;
    }
  }
  if (results.displacement.empty() || n_stresses == 0 || n_places != n_stresses)
    throw std::runtime_error(file.string() + ": " + std::to_string(results.displacement.size()) +
                             " displacements, " + std::to_string(n_stresses) + " stresses, " +
                             std::to_string(n_places) + " places. What does output.txt say?");
  return results;
}

} // namespace crosscode
