#pragma once

#include <array>
#include <string_view>

#include "layout/layout.h"

namespace liftarm::objective {

//! \brief Sizes of the sketch that the paper's terms are normalised by (paper 4.3).
struct Scale {
  double nodes = 1.0;      //!< |V|
  double edges = 1.0;      //!< |E|
  double branching = 1.0;  //!< sum over nodes of (degree - 1) squared
};

Scale scaleOf(const guide::GuidingGraph& graph);

//! \brief All that the terms look at. What is no sum over the layout is measured beside it.
struct Measures {
  layout::Tallies tallies;
  Scale scale;
  int componentRange = 0;          //!< largest layer range within one component
  double symmetryDeviation = 0.0;  //!< paper 4.3, F_sym
  int rigidSubsets = 0;            //!< paper 4.3, F_rgd before normalisation
};

//! The paper's terms (4.3), each in a file of its own; smaller is better.
double deviation(const Measures& m);     //!< F_dev: root mean square layer over holes
double compactness(const Measures& m);   //!< F_cpt: largest layer range of a component, squared
double symmetry(const Measures& m);      //!< F_sym: squared Hausdorff distance per hole
double beamLength(const Measures& m);    //!< F_tbl: holes per node
double pinHeadRatio(const Measures& m);  //!< F_phr: 1 - average pin-head ratio
double collisions(const Measures& m);    //!< F_col: colliding pairs per hole
double gaps(const Measures& m);          //!< F_gap: empty layers per node
double coherence(const Measures& m);     //!< F_coh: failed connections per edge
double rigidity(const Measures& m);      //!< F_rgd: rigid subsets over branching

//! Terms of our own, in plain counts, so that one violation weighs the same in any model (DESIGN
//! 7).
double beamCount(const Measures& m);
double holeCount(const Measures& m);
double layerOffsets(const Measures& m);    //!< holes times layer squared
double overhang(const Measures& m);        //!< beam ends past their line
double hinges(const Measures& m);          //!< joints in line on one hole (DESIGN 7)
double connectionCost(const Measures& m);  //!< connecting parts, and a little for their body
double violations(const Measures& m);      //!< all hard conditions broken

//! \brief One row of the table of terms.
struct Term {
  std::string_view name;
  double (*value)(const Measures& m);
};

//! \brief All terms, in the order of Weights.
inline constexpr std::array<Term, 16> kTerms{{
    {"dev", deviation},
    {"cpt", compactness},
    {"sym", symmetry},
    {"tbl", beamLength},
    {"phr", pinHeadRatio},
    {"col", collisions},
    {"gap", gaps},
    {"coh", coherence},
    {"rgd", rigidity},
    {"beams", beamCount},
    {"holes", holeCount},
    {"layers", layerOffsets},
    {"overhang", overhang},
    {"hinges", hinges},
    {"connections", connectionCost},
    {"violations", violations},
}};

}  // namespace liftarm::objective
