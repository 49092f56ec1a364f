#pragma once

#include "continuum/errors.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

/// A message names the problem, says in brackets why it is one, and asks about a way out.
inline void expect_refusal(std::function<void()> const& act, std::string const& part) {
  try {
    act();
    ADD_FAILURE() << "accepted; expected: " << part;
  } catch (continuum::InvalidInput const& error) {
    std::string const text = error.what();
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_NE(text.find('('), std::string::npos) << text;
    EXPECT_EQ(text.back(), '?') << text;
  }
}
