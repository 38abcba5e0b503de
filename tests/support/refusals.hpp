#pragma once

#include <string>

#include "boxbeam/core/error.hpp"

/// What is said where something is refused.
namespace test {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// What an error of the work says; empty where there is none.
template <class Error = boxbeam::InputError, class Work>
std::string refusal_of(const Work& work) {
  try {
    static_cast<void>(work());
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Its problems, each with what to write.
template <class Work>
std::string complaints_of(const Work& work) {
  std::string all;
  try {
    static_cast<void>(work());
  } catch (const boxbeam::InputError& error) {
    for (const boxbeam::Problem& problem : error.problems())
      all += problem.message + " | " + problem.hint + "\n";
  }
  return all;
}

}  // namespace test
