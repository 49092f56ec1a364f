#include "continuum/session.hpp"

#include <gtest/gtest.h>

// MPI starts once per process, so the tests share one session.
int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  continuum::Session const session;
  return RUN_ALL_TESTS();
}
