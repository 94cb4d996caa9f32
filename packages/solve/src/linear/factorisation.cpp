#include <dmumps_c.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <vector>

#include "linear/factorisation.hpp"

namespace toile::solve {

namespace {
constexpr int initialise = -1, terminate = -2, analyse = 1, numeric = 2, back_substitute = 3;
}

/// Of this rank in the lower triangle of a matrix.
struct LowerTriangle {
  std::vector<MUMPS_INT> rows, columns;  ///< from 1 on
  std::vector<size_t> places;            ///< in the matrix's values
};

static LowerTriangle lower_triangle(const Matrix& matrix) {
  LowerTriangle entries;
  const auto local = matrix.getLocalMatrixHost();
  const auto& row_map = *matrix.getRowMap();
  const auto& column_map = *matrix.getColMap();
  for (LocalId row = 0; row < local.numRows(); ++row) {
    const GlobalId i = row_map.getGlobalElement(row);
    for (size_t k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
      const GlobalId j = column_map.getGlobalElement(local.graph.entries(k));
      if (j > i) continue;
      entries.rows.push_back(static_cast<MUMPS_INT>(i + 1));
      entries.columns.push_back(static_cast<MUMPS_INT>(j + 1));
      entries.places.push_back(k);
    }
  }
  return entries;
}

struct Factorisation::Data {
  DMUMPS_STRUC_C mumps{};
  MPI_Comm comm = MPI_COMM_NULL;
  LowerTriangle entries;
  std::vector<double> values;
  std::vector<int> counts, offsets;  ///< unknowns of each rank (rank 0)
  mutable std::vector<double> rhs;
  bool ready = false;

  int& icntl(int i) { return mumps.icntl[i - 1]; }
  void call(int job) {
    mumps.job = job;
    dmumps_c(&mumps);
  }
};

Factorisation::Factorisation(const Matrix& matrix) : data_(std::make_unique<Data>()) {
  Data& d = *data_;
  const auto comm = Teuchos::rcp_dynamic_cast<const Teuchos::MpiComm<int>>(matrix.getMap()->getComm(), true);
  d.comm = *comm->getRawMpiComm();
  d.mumps.sym = 2;
  d.mumps.par = 1;
  d.mumps.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(d.comm));
  d.call(initialise);
  for (const int stream : {1, 2, 3, 4}) d.icntl(stream) = stream == 4 ? 0 : -1;
  d.icntl(7) = 5;    // METIS ordering
  d.icntl(13) = 1;   // no ScaLAPACK at the root: the count of negative pivots is then complete
  d.icntl(14) = 50;  // spare room for delayed pivots, per cent
  d.icntl(18) = 3;   // entries stay on their ranks

  d.entries = lower_triangle(matrix);
  d.values.resize(d.entries.places.size());
  d.mumps.n = static_cast<MUMPS_INT>(matrix.getGlobalNumRows());
  d.mumps.nnz_loc = static_cast<MUMPS_INT8>(d.entries.places.size());
  d.mumps.irn_loc = d.entries.rows.data();
  d.mumps.jcn_loc = d.entries.columns.data();
  d.mumps.a_loc = d.values.data();
  if (d.mumps.n == 0) return;
  d.call(analyse);

  const int mine = static_cast<int>(matrix.getNodeNumRows());
  const int ranks = comm->getSize();
  d.counts.resize(ranks);
  MPI_Allgather(&mine, 1, MPI_INT, d.counts.data(), 1, MPI_INT, d.comm);
  d.offsets.assign(ranks, 0);
  for (int r = 1; r < ranks; ++r) d.offsets[r] = d.offsets[r - 1] + d.counts[r - 1];
  if (comm->getRank() == 0) d.rhs.resize(d.mumps.n);
  d.mumps.rhs = d.rhs.data();
}

Factorisation::~Factorisation() {
  data_->call(terminate);
}

bool Factorisation::fits(const Matrix& matrix) const {
  const Data& d = *data_;
  const LowerTriangle other = lower_triangle(matrix);
  const bool same = matrix.getGlobalNumRows() == static_cast<Tpetra::global_size_t>(d.mumps.n) &&
                    other.rows == d.entries.rows && other.columns == d.entries.columns &&
                    other.places == d.entries.places;
  int all = same ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, d.comm);
  return all == 1;
}

bool Factorisation::factorise(const Matrix& matrix) {
  Data& d = *data_;
  if (d.mumps.n == 0) return true;
  const auto local = matrix.getLocalMatrixHost();
  for (size_t k = 0; k < d.entries.places.size(); ++k) d.values[k] = local.values(d.entries.places[k]);
  d.call(numeric);
  for (int attempt = 0; attempt < 4 && (d.mumps.infog[0] == -8 || d.mumps.infog[0] == -9); ++attempt) {
    d.icntl(14) *= 2;  // more room for delayed pivots
    d.call(numeric);
  }
  d.ready = d.mumps.infog[0] >= 0;
  return d.ready;
}

int Factorisation::negative_pivots() const {
  return data_->mumps.infog[11];
}

void Factorisation::solve(const MultiVector& b, MultiVector& x) const {
  Data& d = *data_;
  if (d.mumps.n == 0) return;
  const int mine = static_cast<int>(b.getLocalLength());
  for (size_t column = 0; column < b.getNumVectors(); ++column) {
    MPI_Gatherv(b.getData(column).getRawPtr(), mine, MPI_DOUBLE, d.rhs.data(), d.counts.data(), d.offsets.data(),
                MPI_DOUBLE, 0, d.comm);
    d.call(back_substitute);
    MPI_Scatterv(d.rhs.data(), d.counts.data(), d.offsets.data(), MPI_DOUBLE, x.getDataNonConst(column).getRawPtr(),
                 mine, MPI_DOUBLE, 0, d.comm);
  }
}

}  // namespace toile::solve
