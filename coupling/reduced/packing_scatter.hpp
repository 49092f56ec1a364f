#pragma once

#include "coupling/reduced/causes.hpp"
#include "coupling/reduced/press_plan.hpp"

namespace coupling::reduced {

/// How a press cycle departs from packing to packing of the same grains, standard deviations. A
/// force F departs by its share of sqrt(F F_m), F_m the largest of the cycle; so does a pressure.
struct PackingScatter {
  double stress = 0.0;      ///< of both punches' forces together [1]
  double punch = 0.0;       ///< of each punch by itself [1]
  double wall_stress = 0.0; ///< of the radial pressure together with the forces [1]
  double wall = 0.0;        ///< of the radial pressure by itself [1]
  double free_height = 0.0; ///< of the compact that nothing presses, relative [1]
};

/// Of a bed of so many grains: the scatter measured on 2204 grains times sqrt(2204 / n), as means
/// over independent grains go; nothing for n = 0 (a bed of which no grains are known). Source: 12
/// packings of cases/quick (README).
PackingScatter packing_scatter(double n_grains);

/// Covariance of the rows of a plan, n_rows x n_rows, for one packing that presses all its runs.
/// Each departure is a function of where the bed is and has been, that is of the point
/// (ln h_m, ln(h / h_m) / 2.5), h the height and h_m the smallest so far: grains find other
/// neighbours as it closes, fewer as it opens. With m_l Matern-3/2 of length l in natural strain,
///   both punches and wall  1/2 + m_0.045 / 2
///   a punch by itself      m_0.02 / 3 + 2 m_0.12 / 3
///   the wall by itself     m_0.08
Eigen::MatrixXd packing_covariance(Press const& nominal, PressPlan const& plan,
                                   PackingScatter const& scatter);

/// The same where each run is a packing of its own: rows of two runs do not depart together.
Eigen::MatrixXd apart_by_run(Eigen::MatrixXd covariance, PressPlan const& plan);

} // namespace coupling::reduced
