#pragma once

#include "continuum/verification/check.hpp"

// Problems of linear elasticity with known answers, each solved by an ElasticTool as a die or a
// punch is. Need a Session. Seconds of work in all.
namespace continuum::verification {

/// Bore, stress and orders of convergence of a thick-walled tube at 65.7 MPa inside, in plane
/// strain; a = 11.025 mm, b = 30 mm, steel. Meshes of 4 x 16, 8 x 32 and 16 x 64 cells.
/// u_r = (1 + nu)/E [ (1 - 2 nu) A r + B / r ],  sigma_r,t = A -+ B / r^2,
/// A = p a^2 / (b^2 - a^2),  B = p a^2 b^2 / (b^2 - a^2).   Source: Timoshenko, Goodier,
/// section 28.
Checks check_tube_in_plane_strain();

/// The same tube with free ends, 30 MPa, E = 200 GPa:
/// u_r(a) = (p a / E) [ (b^2 + a^2) / (b^2 - a^2) + nu ] = 2.666 um.
Checks check_tube_with_free_ends();

/// NAFEMS LE10: a thick plate (0.6 m) between the ellipses 2 x 1 m and 3.25 x 2.75 m, a quarter of
/// it, 1 MPa on top; outer edge held in the plane, and at half height along z. E = 210 GPa, nu =
/// 0.3. Stress sigma_yy at D = (2, 0, 0.6) m: -5.38 MPa.
/// Source: NAFEMS, The Standard NAFEMS Benchmarks, TNSB Rev. 3 (1990), LE10.
Checks check_thick_elliptic_plate();

/// A field that is made up, u = c z sin(k.x), on a curved block clamped at z = 0, under the body
/// force and the tractions that it needs: the orders 3 of u and 2 of stress, away from any
/// symmetry.
Checks check_manufactured_solution();

/// A beam of 200 x 20 x 10 mm under 10 N across, E = 200 GPa, nu = 0.3: cantilever F L^3 / (3 E I),
/// and clamped at both ends F L^3 / (192 E I); shear adds F L / (kappa G A) and a quarter of that,
/// kappa = 10 (1 + nu) / (12 + 11 nu).   Source: Timoshenko; Cowper (1966) for kappa.
Checks check_beams();

/// Discs of 50 mm radius and 5 mm thickness under 1 kN in the middle, E = 200 GPa, nu = 0.3,
/// clamped and simply supported. The load is the pressure 3 F / (pi c^2) (1 - r^2/c^2)^2 on r < c =
/// 10 mm, since a point load sinks into a solid; by reciprocity with the point load's bending
/// (Timoshenko, Woinowsky-Krieger, eqs 92 and 88) the middle moves by
///   clamped            F / (8 pi D) [ a^2/2 - c^2/4 ln(a/c) - 25 c^2/96 ]
///   simply supported   F / (16 pi D) [ (3 + nu)/(1 + nu) (a^2 - c^2/4) - c^2/2 ln(a/c) - 13 c^2/48
///   ]
/// and shear adds F / (2 pi kappa G h) [ ln(a/c) + 11/12 ], kappa = 5/6. With c = 0 and without
/// shear these are F a^2 / (16 pi D) = 21.72 um and 55.15 um.
Checks check_discs();

/// Hertz's pressure p0 sqrt(1 - r^2/a^2) of 1 kN on a = 1 mm of a block of 100 mm (a quarter of a
/// body of 200 mm), E = 200 GPa, nu = 0.3: the middle sinks by 3 (1 - nu^2) F / (4 E a) = 3.4125
/// um, and the largest shear stress below it is 0.310 p0.   Source: Johnson, Contact
/// Mechanics, 3.4.
Checks check_hertz_pressure();

/// A column of H = 20 mm in a rigid, smooth box under p = 65.72 MPa:
/// u = p H (1 + nu) (1 - 2 nu) / (E (1 - nu)) = 4.882 um, sigma_x = nu / (1 - nu) sigma_z.
Checks check_column();

/// All of them.
Checks check_elasticity();

} // namespace continuum::verification
