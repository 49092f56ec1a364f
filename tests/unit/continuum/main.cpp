#include "continuum/session.hpp"

#include <gtest/gtest.h>

// MPI starts once per process, so the tests share one session. Under `mpirun -n N` the same tests
// run over ranks.
int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  continuum::Session const session;
  if (continuum::Session::is_helper())
    return continuum::Session::help(), 0;
  return RUN_ALL_TESTS();
}
