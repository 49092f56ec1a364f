#include "coupling/quantity.hpp"

#include "coupling/nearest_name.hpp"
#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace coupling {
namespace {

/// The message of a refusal, or "accepted".
std::string refusal(std::string_view text, Physical physical) {
  try {
    parse_quantity(text, physical);
    return "accepted";
  } catch (dem::InvalidInput const& problem) {
    return problem.what();
  }
}

TEST(QuantityUnits, GiveTheSameBitsAsTheLiteralInSi) {
  EXPECT_EQ(parse_quantity("22.05 mm", Physical::length), 22.05e-3);
  EXPECT_EQ(parse_quantity("9.13 g", Physical::mass), 9.13e-3);
  EXPECT_EQ(parse_quantity("7e6 J/m^3", Physical::energy_density), 7e6);
  EXPECT_EQ(parse_quantity("250 MPa", Physical::modulus), 250e6);
  EXPECT_EQ(parse_quantity("35 %", Physical::ratio), 0.35);
  EXPECT_EQ(parse_quantity("25.1 kN", Physical::force), 25.1e3);
  EXPECT_EQ(parse_quantity("1e-5 s", Physical::time), 1e-5);
  EXPECT_EQ(parse_quantity("0.3\u00b5m", Physical::length), 0.3e-6);
}

TEST(QuantityUnits, CombineByProductPowerAndQuotient) {
  // 1 mm/min = 1e-3 m / 60 s
  EXPECT_DOUBLE_EQ(parse_quantity("1 mm/min", Physical::speed), 1e-3 / 60.0);
  // 1 g/cm^3 = 1e-3 kg / 1e-6 m^3
  EXPECT_EQ(parse_quantity("3.5 g/cm^3", Physical::density), 3500.0);
  EXPECT_EQ(parse_quantity("9.81 N/kg", Physical::acceleration), 9.81);
  EXPECT_EQ(parse_quantity("9.81 m s^-2", Physical::acceleration), 9.81);
  EXPECT_EQ(parse_quantity("50 mJ/m^2", Physical::surface_energy), 0.05);
  EXPECT_EQ(parse_quantity("3 rad/s", Physical::angular_speed), 3.0);
  EXPECT_EQ(parse_quantity("1 N*m/m^2", Physical::surface_energy), 1.0);
  EXPECT_DOUBLE_EQ(parse_quantity("180 deg", Physical::ratio), dem::pi);
}

TEST(QuantityUnits, TakeABareNumberAsSi) {
  EXPECT_EQ(parse_quantity("0.29", Physical::ratio), 0.29);
  EXPECT_EQ(parse_quantity("  +2.205e-2 ", Physical::length), 22.05e-3);
  EXPECT_EQ(parse_quantity("-.5", Physical::speed), -0.5);
}

TEST(QuantityUnits, RefuseAnotherDimensionAndNameTheOnesThatFit) {
  EXPECT_EQ(refusal("9 mm", Physical::mass),
            "has a unit that does not fit (a mass is needed). Write it in kg, g, mg?");
  EXPECT_EQ(refusal("5 m/s^2", Physical::speed),
            "has a unit that does not fit (a speed is needed). Write it in m/s, mm/s, mm/min?");
  EXPECT_EQ(refusal("5 %", Physical::length),
            "has a unit that does not fit (a length is needed). Write it in m, mm, um?");
}

TEST(QuantityUnits, RefuseAnUnknownUnitAndNameTheNearest) {
  EXPECT_EQ(
      refusal("5 mmm", Physical::length),
      "'mmm' is no unit that presscheck knows (units are case-sensitive). Did you mean 'mm'?");
  EXPECT_EQ(
      refusal("250 mpa", Physical::modulus),
      "'mpa' is no unit that presscheck knows (units are case-sensitive). Did you mean 'MPa'?");
  EXPECT_EQ(refusal("5 kg/m^x", Physical::density),
            "'m^x' is no power of a unit (a caret is followed by 1 to 9). Write m^3?");
  EXPECT_EQ(refusal("5 furlong", Physical::length),
            "'furlong' is no unit that presscheck knows (units are case-sensitive). Write it in SI "
            "units?");
}

TEST(QuantityNumbers, RefuseWhatIsNoFiniteNumber) {
  std::string const not_finite = "is no finite number (a time is needed). Give it a value?";
  for (char const* text : {"nan", "NaN s", "inf", "-inf s", "+Infinity"})
    EXPECT_EQ(refusal(text, Physical::time), not_finite);
  std::string const range = "is too large or too small for a number (double precision ends at "
                            "1e308). Check the exponent?";
  for (char const* text : {"1e999", "1e306 km", "-1e400 m", "1e-999 mm", "1e99999999999999999999"})
    EXPECT_EQ(refusal(text, Physical::length), range);
  // 1e308 h: the number is finite, 3600 times it is not
  EXPECT_EQ(refusal("1e308 h", Physical::time),
            "is too large for a number (double precision ends at 1e308). Check the exponent?");
}

TEST(QuantityNumbers, RefuseEmptyWordsAndDecimalCommas) {
  EXPECT_EQ(refusal("", Physical::time), "is empty (a time is needed). Give it a value?");
  EXPECT_EQ(
      refusal("fast", Physical::speed),
      "does not start with a number (a speed is needed, in m/s, mm/s, mm/min). Give it a value?");
  EXPECT_EQ(refusal("1,5 mm", Physical::length),
            "holds a comma (decimals are written with a point). Write 1.5 mm?");
  for (char const* text : {".", "-", "e5", "0x10", "--5", "5 /", "5 mm mm", "5 m^", "5 ^2"})
    EXPECT_NE(refusal(text, Physical::length), "accepted") << text;
}

TEST(QuantityPrinting, IsReadBackToTheSameBits) {
  for (double const value :
       {22.05e-3, 1.0 / 3.0, 5e-324, std::numeric_limits<double>::max(), -0.2, 0.0, 1e22}) {
    EXPECT_EQ(parse_quantity(print_quantity(value, Physical::length), Physical::length), value);
    EXPECT_EQ(parse_quantity(print_quantity(value, Physical::ratio), Physical::ratio), value);
  }
  EXPECT_EQ(print_quantity(22.05e-3, Physical::length), "0.02205 m");
  EXPECT_EQ(print_quantity(0.35, Physical::ratio), "0.35");
}

TEST(NearestName, CountsEditsAndIgnoresCase) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u); // k->s, e->i, +g
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("MPA", "mpa"), 0u);
  std::vector<std::string> const names = {"Density", "Total mass"};
  EXPECT_EQ(nearest_name("Totl mas", names), "Total mass");
  EXPECT_EQ(nearest_name("Temperature", names), "");
}

} // namespace
} // namespace coupling
