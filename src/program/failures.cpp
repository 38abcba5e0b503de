#include "program/failures.hpp"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>

#include "boxbeam/core/error.hpp"
#include "program/exit_code.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {
namespace {

int not_done(const std::string& why) {
  put_error("the analysis cannot be done\n  " + why);
  return not_possible;
}

}  // namespace

int exit_code_of(const std::function<int()>& command) {
  try {
    return command();
  } catch (const InputError& error) {
    std::cerr << error.what();
    if (error.problems().size() > 1)
      std::cerr << error.problems().size() << " errors; nothing was written\n";
    return wrong_input;
  } catch (const AnalysisError& error) {
    return not_done(error.what());
  } catch (const OutputError& error) {
    put_error(error.what());
    return output_failed;
  } catch (const std::filesystem::filesystem_error& error) {
    // The working folder may be gone, or a folder on the way to it closed.
    put_error(fmt::format("a file or folder cannot be reached: {}", error.what()));
    return output_failed;
  } catch (const std::bad_alloc&) {
    return not_done(
        "the memory does not suffice: the case counts too much (parts of links, instants, segments "
        "or situations)");
  } catch (const std::exception& error) {
    return not_done(fmt::format(
        "a numerical method gave up without a reason that is known here ({}): the values of the "
        "case are probably far from any that can be meant",
        error.what()));
  } catch (...) {
    return not_done("a numerical method gave up without a word");
  }
}

}  // namespace boxbeam::program
