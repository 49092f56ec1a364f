#pragma once

#include <stdexcept>
#include <string>

/// The checking language of dem/.
///  - VALIDATE(condition, message): always on; for what a person wrote or a file holds.
///  - EXPECT / ENSURE: contracts on entry and exit; on in debug and audit builds
///  (PRESSCHECK_CONTRACTS).
/// The message grammar: `where: what is wrong (why it is). A way out?`
namespace dem {

/// What a person wrote, or a file holds, cannot be used. `presscheck` prints it and exits with
/// status 2.
struct InvalidInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A guard stopped the calculation because its result could not be trusted. Exit status 1.
struct PhysicsGuard : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A contract of the program itself was broken: a defect of ours, never of the input.
struct ContractViolation : std::logic_error {
  using std::logic_error::logic_error;
};

[[noreturn]] inline void contract_violated(char const* kind, char const* condition,
                                           char const* file, int line) {
  throw ContractViolation(std::string(file) + ":" + std::to_string(line) + ": " + kind + "(" +
                          condition +
                          ") does not hold. This is a defect of presscheck, please report it");
}

} // namespace dem

#define VALIDATE(condition, message)                                                               \
  do {                                                                                             \
    if (!(condition))                                                                              \
      throw ::dem::InvalidInput(message);                                                          \
  } while (false)

#ifdef PRESSCHECK_CONTRACTS
#define EXPECT(condition)                                                                          \
  do {                                                                                             \
    if (!(condition))                                                                              \
      ::dem::contract_violated("EXPECT", #condition, __FILE__, __LINE__);                          \
  } while (false)
#define ENSURE(condition)                                                                          \
  do {                                                                                             \
    if (!(condition))                                                                              \
      ::dem::contract_violated("ENSURE", #condition, __FILE__, __LINE__);                          \
  } while (false)
#else
#define EXPECT(condition) ((void)0)
#define ENSURE(condition) ((void)0)
#endif
