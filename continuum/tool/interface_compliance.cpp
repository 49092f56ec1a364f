#include "continuum/tool/interface_compliance.hpp"

#include "continuum/expect.hpp"
#include "continuum/hash.hpp"
#include "continuum/tool/shared_inverse.hpp"

#include <cstdio>

namespace continuum {

namespace {
Eigen::MatrixXd inverted(Eigen::MatrixXd stiffness, std::string const& surface) {
  try {
    return shared_inverse(std::move(stiffness));
  } catch (SolverFailure const& failure) {
    throw SolverFailure("surface '" + surface + "': " + failure.what());
  }
}
} // namespace

InterfaceCompliance::InterfaceCompliance(Eigen::MatrixXd matrix, std::uint64_t key)
    : matrix_(std::move(matrix)), key_(key) {}

std::uint64_t InterfaceCompliance::key(ElasticTool const& tool, std::string const& surface) {
  return Fnv().add(tool.hash()).add(surface).value();
}

InterfaceCompliance InterfaceCompliance::condense(ElasticTool const& tool,
                                                  std::string const& surface) {
  std::vector<std::uint32_t> const nodes = tool.mesh().trace(surface).nodes;
  std::vector<int> keep;   // components of the mesh
  std::vector<int> places; // where they stand in C
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (int c = 0; c < 3; ++c)
      if (!tool.is_held()[3 * nodes[a] + c]) {
        keep.push_back(3 * nodes[a] + c);
        places.push_back(3 * a + c);
      }
  VALIDATE(!keep.empty(), "surface '" + surface +
                              "' is held in all components (it cannot yield). Support the tool "
                              "elsewhere, or keep it rigid?");
  Eigen::MatrixXd const inverse = inverted(tool.condensed_stiffness(keep), surface);
  auto const n = static_cast<Eigen::Index>(keep.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * nodes.size(), 3 * nodes.size());
  // Symmetric to the bit: work then depends on the end state only, however it was reached.
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i)
      matrix(places[i], places[j]) = 0.5 * (inverse(i, j) + inverse(j, i));
  return InterfaceCompliance(std::move(matrix), key(tool, surface));
}

InterfaceCompliance InterfaceCompliance::cached(ElasticTool const& tool, std::string const& surface,
                                                std::filesystem::path const& folder) {
  char name[40];
  std::snprintf(name, sizeof name, "compliance-%016llx.h5",
                static_cast<unsigned long long>(key(tool, surface)));
  if (std::filesystem::exists(folder / name))
    return load(folder / name, key(tool, surface));
  InterfaceCompliance compliance = condense(tool, surface);
  compliance.save(folder / name);
  return compliance;
}

Eigen::Matrix3Xd InterfaceCompliance::displacement(Eigen::Matrix3Xd const& forces) const {
  VALIDATE(forces.size() == matrix_.cols(),
           "forces on " + std::to_string(forces.cols()) + " nodes for a compliance of " +
               std::to_string(matrix_.cols() / 3) +
               " nodes (one force a node). Do they come from another surface?");
  Eigen::Matrix3Xd moved(3, forces.cols());
  // The lower triangle alone is half the memory traffic, which is what the product costs.
  moved.reshaped().noalias() = matrix_.selfadjointView<Eigen::Lower>() * forces.reshaped();
  return moved;
}

} // namespace continuum
