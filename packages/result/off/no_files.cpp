#include "toile/base/error.hpp"
#include "toile/result/available.hpp"
#include "toile/result/exodus_writer.hpp"
#include "toile/result/history.hpp"
#include "toile/result/results_file.hpp"
#include "toile/result/state_file.hpp"

namespace toile::result {

bool files_available() {
  return false;
}

ExodusWriter::ExodusWriter(const std::string& path, const mesh::Mesh&, const body::TriangleMesh*, const FieldNames&)
    : path_(path) {}
void ExodusWriter::go_on(int steps) {
  steps_ = steps;
}
void ExodusWriter::write_step(double, const StepData&) {
  ++steps_;
}

History::History(const std::string& path, const std::vector<FieldName>&) : path_(path) {}
void History::restore(const std::vector<std::vector<double>>& rows) {
  rows_ = static_cast<int>(rows.size());
}
void History::append(const std::vector<double>&) {
  ++rows_;
}

void write_state(const std::string&, const StateData&) {}
StateData read_state(const std::string& path) {
  throw base::InputError(path + ": this build of Toile reads no HDF5 (configured with TOILE_ENABLE_RESULT=OFF)");
}

Results read_results(const std::string& path) {
  throw base::InputError(path +
                         ": this build of Toile reads no Exodus files (configured with TOILE_ENABLE_RESULT=OFF)");
}

}  // namespace toile::result
