#include "continuum/powder/avicel_ph102.hpp"

#include <numbers>

namespace continuum {
namespace {

constexpr double MPa = 1e6, degree = std::numbers::pi / 180.0;

PiecewiseLinear in_units(PiecewiseLinear table, double unit) {
  for (auto& row : table.rows)
    row.value *= unit;
  return table;
}

PiecewiseLinear hardening() {
  return in_units({{0.0, 0.609},
                   {0.287682, 4.03},
                   {0.510826, 10.7},
                   {0.693147, 20.5},
                   {0.847298, 35.78},
                   {0.980829, 64.7},
                   {1.098612, 127.9},
                   {1.131402, 170.0},
                   {1.16, 257.0}, // D = 0.957, though the row of the other properties is 0.96
                   {1.193922, 368.0},
                   {1.202972, 823.0},
                   {1.203872, 1300.0}},
                  MPa);
}

DensityElasticity elasticity() {
  return {.young_modulus = in_units({{0.3003, 45.0},
                                     {0.3504, 94.0},
                                     {0.4004, 177.0},
                                     {0.4508, 302.0},
                                     {0.5009, 482.0},
                                     {0.5514, 732.0},
                                     {0.6001, 1053.0},
                                     {0.6506, 1491.0},
                                     {0.7006, 2057.5},
                                     {0.7516, 2785.3},
                                     {0.8027, 3714.6},
                                     {0.8527, 4850.4},
                                     {0.9041, 6323.5},
                                     {0.9509, 8026.2},
                                     {0.98, 9305.8},
                                     {0.999, 10142.4}},
                                    MPa),
          .poisson_ratio = {{0.3003, 0.016},
                            {0.3504, 0.025},
                            {0.4004, 0.035},
                            {0.4508, 0.047},
                            {0.5009, 0.061},
                            {0.5514, 0.077},
                            {0.6001, 0.094},
                            {0.6506, 0.114},
                            {0.7006, 0.136},
                            {0.7516, 0.1606},
                            {0.8027, 0.1878},
                            {0.8527, 0.2171},
                            {0.9041, 0.2507},
                            {0.9509, 0.2854},
                            {0.98, 0.3094},
                            {0.999, 0.3242}}};
}

} // namespace

DruckerPragerCap avicel_ph102(HardeningReading reading) {
  constexpr double start = 0.3411, first_row = 0.30;
  return {.cohesion = in_units({{0.30, 0.026759},
                                {0.40, 0.7225},
                                {0.50, 1.15600},
                                {0.60, 3.12432},
                                {0.70, 5.84879},
                                {0.80, 10.5116},
                                {0.90, 18.645},
                                {0.93, 29.979},
                                {0.96, 34.08},
                                {0.99, 56.863},
                                {0.999, 70.397},
                                {0.9999, 75.555}},
                               MPa),
          .friction_angle = in_units({{0.30, 54.3546},
                                      {0.40, 68.7764},
                                      {0.50, 68.3426},
                                      {0.60, 68.0337},
                                      {0.70, 68.0709},
                                      {0.80, 67.4225},
                                      {0.90, 66.5088},
                                      {0.93, 66.324},
                                      {0.96, 65.6889},
                                      {0.99, 63.395},
                                      {0.999, 62.097},
                                      {0.9999, 61.821}},
                                     degree),
          .eccentricity = {{0.30, 0.271},
                           {0.40, 0.312},
                           {0.50, 0.586},
                           {0.60, 0.640},
                           {0.70, 0.690},
                           {0.80, 0.789},
                           {0.90, 0.907},
                           {0.93, 1.02},
                           {0.96, 1.30},
                           {0.99, 1.608},
                           {0.999, 3.8},
                           {0.9999, 6.2}},
          .hardening = hardening(),
          .hardening_reference_density = reading == HardeningReading::as_filed ? start : first_row,
          .initial_relative_density = start,
          .elasticity = elasticity()};
}

PiecewiseLinear avicel_ph102_wall_friction(WallLubrication lubrication) {
  switch (lubrication) {
  case WallLubrication::powder:
    return {{0.30, 0.10789}, {1.0, 0.10789 + 0.1593 * 0.70}};
  case WallLubrication::die:
    return {{0.30, 0.918},  {0.40, 0.302},  {0.50, 0.1875}, {0.60, 0.1661},
            {0.70, 0.1621}, {0.80, 0.1614}, {1.0, 0.1612}};
  case WallLubrication::none:
    break;
  }
  return 0.161;
}

} // namespace continuum
