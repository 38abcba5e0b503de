#pragma once

#include <memory>
#include <vector>

#include "boxbeam/project/signal_file.hpp"
#include "file_bytes.hpp"
#include "row_block.hpp"

namespace boxbeam {

/// A file whose head has been read. A format is one derived class and the function that opens it.
class SignalReader {
 public:
  virtual ~SignalReader() = default;
  const SignalHead& head() const { return head_; }
  /// Goes through all rows, once; `columns` are indices of channels. Throws InputError.
  virtual void read(const std::vector<std::size_t>& columns, RowBlock& block) = 0;

 protected:
  SignalHead head_;
};

using OpenedSignals = std::unique_ptr<SignalReader>;
using SignalBytes = std::unique_ptr<FileBytes>;

OpenedSignals open_csv_signals(SignalBytes bytes, const SignalSource& source);
OpenedSignals open_openfast_text(SignalBytes bytes, const SignalSource& source);
OpenedSignals open_openfast_binary(SignalBytes bytes, const SignalSource& source);
OpenedSignals open_mbdyn_signals(SignalBytes bytes, const SignalSource& source);
OpenedSignals open_exudyn_sensor(SignalBytes bytes, const SignalSource& source);
OpenedSignals open_request_table(SignalBytes bytes, const SignalSource& source);
OpenedSignals open_request_steps(SignalBytes bytes, const SignalSource& source);
OpenedSignals open_rpc3_signals(SignalBytes bytes, const SignalSource& source);
OpenedSignals open_netcdf_signals(SignalBytes bytes, const SignalSource& source);

/// The format of a file by its content and name, or as asked.
SignalFormat format_of(const FileBytes& bytes, const SignalSource& source);

/// Opens it by the reader of that format.
OpenedSignals open_signals(const SignalSource& source);

/// Fails where a step is given for a file that has its own time.
void refuse_time_step(const FileBytes& bytes, const SignalSource& source);

}  // namespace boxbeam
