#include "tests/crosscode/calculix/deck.hpp"

#include <fmt/os.h>

#include <stdexcept>

namespace crosscode {

namespace {
void write_mesh(fmt::ostream& deck, continuum::ToolMesh const& mesh) {
  auto const shared = is_shared(mesh);
  deck.print("*NODE, NSET=ALL\n");
  for (std::size_t a = 0; a < mesh.n_nodes(); ++a)
    if (shared[a]) // 20 characters a number is what the peer reads
      deck.print("{}, {:.13e}, {:.13e}, {:.13e}\n", a + 1, mesh.nodes()(0, a), mesh.nodes()(1, a),
                 mesh.nodes()(2, a));
  for (std::size_t region = 0; region < mesh.n_regions(); ++region) {
    deck.print("*ELEMENT, TYPE=C3D20, ELSET=REGION{}\n", region);
    for (std::size_t cell = 0; cell < mesh.n_cells(); ++cell) {
      if (mesh.region(cell) != region)
        continue;
      deck.print("{}", cell + 1);
      auto const nodes = serendipity_nodes(mesh, cell);
      for (std::size_t n = 0; n < nodes.size(); ++n)
        deck.print("{}{}", n == 10 ? ",\n" : ", ", nodes[n] + 1); // at most 16 entries a line
      deck.print("\n");
    }
  }
}

void write_materials(fmt::ostream& deck, continuum::ElasticTool const& tool) {
  for (std::size_t region = 0; region < tool.materials().size(); ++region)
    deck.print("*MATERIAL, NAME=M{0}\n*ELASTIC\n{1:.13e}, {2:.13e}\n"
               "*SOLID SECTION, ELSET=REGION{0}, MATERIAL=M{0}\n",
               region, tool.materials()[region].young_modulus,
               tool.materials()[region].poisson_ratio);
}
} // namespace

std::array<std::uint32_t, 20> serendipity_nodes(continuum::ToolMesh const& mesh, std::size_t cell) {
  // (i, j, k) of each node, 0, 1 or 2: corners below and above, sides below, above and upright.
  static constexpr std::array<std::array<unsigned, 3>, 20> places = {
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
       {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
       {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};
  auto const all = mesh.cell_nodes(cell);
  std::array<std::uint32_t, 20> nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    nodes[n] = all[9 * places[n][2] + 3 * places[n][1] + places[n][0]];
  return nodes;
}

std::vector<bool> is_shared(continuum::ToolMesh const& mesh) {
  std::vector<bool> shared(mesh.n_nodes(), false);
  for (std::size_t cell = 0; cell < mesh.n_cells(); ++cell)
    for (std::uint32_t const node : serendipity_nodes(mesh, cell))
      shared[node] = true;
  return shared;
}

void write_deck(std::filesystem::path const& file, continuum::ElasticTool const& tool,
                Eigen::Matrix3Xd const& loads) {
  auto const shared = is_shared(tool.mesh());
  fmt::ostream deck = fmt::output_file(file.string());
  write_mesh(deck, tool.mesh());
  write_materials(deck, tool);
  deck.print("*BOUNDARY\n");
  for (std::size_t i = 0; i < tool.is_held().size(); ++i)
    if (tool.is_held()[i] && shared[i / 3])
      deck.print("{}, {}\n", i / 3 + 1, i % 3 + 1);
  deck.print("*STEP\n*STATIC\n*CLOAD\n");
  for (Eigen::Index i = 0; i < loads.size(); ++i) {
    if (loads.data()[i] == 0.0)
      continue;
    if (!shared[i / 3])
      throw std::runtime_error(fmt::format("a force on node {}, which C3D20 does not have", i / 3));
    deck.print("{}, {}, {:.13e}\n", i / 3 + 1, i % 3 + 1, loads.data()[i]);
  }
  deck.print("*NODE PRINT, NSET=ALL\nU\n");
  for (std::size_t region = 0; region < tool.mesh().n_regions(); ++region)
    deck.print("*EL PRINT, ELSET=REGION{}\nS, COORD\n", region);
  deck.print("*END STEP\n");
}

} // namespace crosscode
