#pragma once

#include <Teuchos_Comm.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

namespace toile::solve {

using LocalId = int;         ///< of an unknown, on this rank
using GlobalId = long long;  ///< of an unknown, of all ranks
using LocalCluster = int;    ///< index among the clusters of this rank: owned ones first, then ghosts
using GlobalCluster = int;   ///< index into Problem::clusters
using LocalNode = int;       ///< index among the nodes of this rank
using GlobalNode = int;      ///< index into the mesh's nodes
using Node = Tpetra::Map<>::node_type;
using Map = Tpetra::Map<LocalId, GlobalId, Node>;
using Import = Tpetra::Import<LocalId, GlobalId, Node>;
using Vector = Tpetra::Vector<double, LocalId, GlobalId, Node>;
using MultiVector = Tpetra::MultiVector<double, LocalId, GlobalId, Node>;
using Graph = Tpetra::CrsGraph<LocalId, GlobalId, Node>;
using Matrix = Tpetra::CrsMatrix<double, LocalId, GlobalId, Node>;
using Operator = Tpetra::Operator<double, LocalId, GlobalId, Node>;
using Comm = Teuchos::Comm<int>;
using Teuchos::RCP;
using Teuchos::rcp;

}  // namespace toile::solve
