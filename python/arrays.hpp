#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "boxbeam/report/motion_columns.hpp"

namespace boxbeam::python {

/// Numbers of an array that are read where they are: contiguous doubles are not copied.
using Samples = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// An array of numpy around numbers that stay where they are.
inline pybind11::array_t<double> array_of(std::vector<double>&& numbers) {
  auto owned = std::make_unique<std::vector<double>>(std::move(numbers));
  const auto size = static_cast<pybind11::ssize_t>(owned->size());
  double* const data = owned->data();
  const pybind11::capsule owner(owned.release(),
                                [](void* of) { delete static_cast<std::vector<double>*>(of); });
  return pybind11::array_t<double>(size, data, owner);
}

/// Columns by their names, numbers as arrays around what stays where it is.
pybind11::dict columns_of(std::vector<MotionColumn>&& columns);

/// Cycles and damage of stresses in arrays.
void add_fatigue(pybind11::module_& module);

}  // namespace boxbeam::python
