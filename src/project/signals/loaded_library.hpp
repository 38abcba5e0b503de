#pragma once

#include <dlfcn.h>

#include <initializer_list>
#include <type_traits>

namespace boxbeam {

/// A shared library that is loaded when it is first needed: with all that it brings the program
/// would take longer to start for all others.
class LoadedLibrary {
 public:
  /// By the first name that there is.
  explicit LoadedLibrary(std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (library_ == nullptr) library_ = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
    complete_ = library_ != nullptr;
  }

  /// A function of its own by its name; what is missing makes the library one that is not there.
  template <class Function>
  void take(Function& function, const char* name) {
    if (library_ == nullptr) return;
    function = reinterpret_cast<std::decay_t<Function>>(::dlsym(library_, name));
    complete_ = complete_ && function != nullptr;
  }

  bool is_there() const { return complete_; }

 private:
  void* library_ = nullptr;
  bool complete_ = false;
};

/// Of libnetcdf 4.
inline constexpr std::initializer_list<const char*> netcdf_names{"libnetcdf.so.19", "libnetcdf.so"};

}  // namespace boxbeam
