#pragma once

#include "tests/diagnosis/grains/simulations.hpp"

#include <string>
#include <utility>
#include <vector>

namespace hidden {

/// The press cycle as LIGGGHTS 3.8 is to run it: its own random filling, Hertz and Mindlin with
/// history, SJKR2 between grains, exact cylinder, punches as single triangles wider than the bore
/// (its plane walls cannot move and report their force). It leaves curves.txt (see read_peer).
/// @return  names and texts of the files that it reads; in.press is the first
/// @throws std::invalid_argument for entries that only the own program has
std::vector<std::pair<std::string, std::string>> deck_of(GrainPress const& press);

} // namespace hidden
