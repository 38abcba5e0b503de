#pragma once

#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <sstream>
#include <string>
#include <unordered_map>

#include "catch.hpp"

namespace test {

/// Checks a property by RapidCheck inside a test case: the same cases on every machine, and with a
/// failure the smallest counterexample.
template <class Property>
void holds(Property property, int cases = 200) {
  rc::detail::TestParams params;
  params.seed = 1049;
  params.maxSuccess = cases;
  // Not the environment's settings, which rc::check would take and print.
  rc::detail::TestListenerAdapter silent;
  const auto result =
      rc::detail::checkTestable(property, rc::detail::TestMetadata{}, params, silent,
                                std::unordered_map<std::string, rc::detail::Reproduce>{});
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  INFO(message.str());
  CHECK(result.template is<rc::detail::SuccessResult>());
}

}  // namespace test
