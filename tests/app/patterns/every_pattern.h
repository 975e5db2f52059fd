// One small example of every pattern that a case file knows, in every one of its forms.
#pragma once

#include <string>
#include <vector>

namespace voussoir::app::patterns_test
{

/// An entry of `blocks`.
struct PatternExample {
    std::string name;
    std::string entry;
};

inline const std::vector<PatternExample> every_pattern = {
    {"circular arch", "arch: {span: 6 m, embrace: 140 deg, thickness: 0.6 m, voussoirs: 13}"},
    {"pointed arch",
     "arch: {span: 6 m, shape: pointed, thickness: 0.6 m, voussoirs: 15, imperfection: {size: 2 %, friction: 10 "
     "%}}"},
    {"elliptic arch", "arch: {span: 6 m, shape: elliptic, rise: 2.2 m, thickness: 0.9 m, voussoirs: 13}"},
    {"polycentric arch", "arch: {span: 6 m, shape: polycentric, rise: 2.2 m, thickness: 0.9 m, voussoirs: 13}"},
    {"bridge",
     "bridge: {span: 6 m, rise: 2 m, thickness: 0.6 m, voussoirs: 15, width: 3 m, block: [1 m, 0.5 m], "
     "spandrel_thickness: 0.5 m, cover: 0.3 m, fill: mass}"},
    {"bridge of unequal spans",
     "bridge: {spans: [{span: 4 m, voussoirs: 11}, {span: 6 m, voussoirs: 15}], embrace: 150 deg, thickness: 0.6 "
     "m, width: 3 m, block: [1 m, 0.5 m], pier_height: 1.5 m, cutwater: 0.6 m, spandrel_thickness: 0.5 m, "
     "backing: 0.8 m, cover: 0.3 m, parapet: {height: 0.6 m}, fill: blocks}"},
    {"square tower",
     "tower: {width: 3 m, block: [0.8 m, 0.4 m], storeys: [{height: 2 m, thickness: 0.6 m, openings: [{side: "
     "east, width: 0.6 m, height: 1.2 m}]}, {name: belfry, height: 1.2 m, thickness: 0.5 m}]}"},
    {"octagonal tower",
     "tower: {plan: octagonal, width: 6 m, block: [0.8 m, 0.4 m], storeys: [{height: 2 m, thickness: 0.8 m, "
     "floor: 3 t}]}"},
    {"round tower",
     "tower: {plan: round, width: 4 m, block: [0.8 m, 0.4 m], storeys: [{height: 1.2 m, thickness: 0.8 m}]}"},
    {"column", "column: {height: 6 m, diameter: 1 m, entasis: 1 cm, capital: {height: 0.6 m, width: 1.2 m}}"},
    {"temple front",
     "temple_front: {height: 5 m, diameter: 1 m, spacing: 3 m, capital: {height: 0.5 m, width: 1.2 m}, frieze: "
     "0.5 m, pediment: 1.2 m}"},
    {"dome", "dome: {radius: 5 m, thickness: 0.5 m, keystone: true}"},
    {"half dome",
     "{dome: {radius: 4 m, thickness: 0.5 m, half: true, stones: 8}, groups: {foundation: \"front*\"}}"},
    {"dome with a lantern", "dome: {radius: 4 m, thickness: 0.5 m, stones: 12, lantern: {height: 1 m}}"},
    {"barrel vault", "barrel_vault: {span: 5 m, thickness: 0.6 m, length: 4 m}"},
    {"groin vault", "cross_vault: {span: 5 m, rise: 2.5 m, thickness: 0.5 m, courses: 7, stones: 3}"},
    {"ribbed vault",
     "cross_vault: {span: 5 m, rise: 2.5 m, thickness: 0.5 m, courses: 7, stones: 3, ribs: {width: 0.3 m}}"},
    {"gate",
     "gate: {span: 3 m, thickness: 0.5 m, voussoirs: 13, depth: 1.2 m, block: [0.8 m, 0.4 m], pier: {width: 1.6 "
     "m, height: 2 m}}"},
    {"buttress",
     "buttress: {width: 1 m, block: [0.8 m, 0.4 m], stages: [{height: 2 m, depth: 1.6 m}, {height: 1 m, depth: "
     "0.9 m}]}"},
    {"flying buttress",
     "flying_buttress: {span: 4 m, rise: 3 m, thickness: 0.6 m, voussoirs: 9, block: [0.8 m, 0.4 m], pier: "
     "{depth: 1.8 m, height: 2 m}, pinnacle: 1 m}"},
    {"steps", "steps: {number: 4, width: 3 m}"},
    {"obelisk", "obelisk: {height: 6 m, width: 1 m, stones: 3, pedestal: {height: 0.6 m, width: 1.4 m}}"},
    {"pinnacle", "pinnacle: {width: 0.6 m, height: 1.2 m, spire: 2 m}"},
    {"wall",
     "{wall: {length: 3 m, height: 2.4 m, thickness: 0.4 m, block: [0.6 m, 0.3 m], openings: [{at: 1 m, width: "
     "0.8 m, height: 1.5 m}], base: {height: 0.3 m}}, groups: {foundation: \"*_base\"}}"},
    {"three-leaf wall",
     "{wall: {length: 2 m, height: 1.5 m, thickness: 0.85 m, block: [0.6 m, 0.3 m], leaves: [25 cm, 40 cm, 20 "
     "cm], base: {height: 0.3 m}}, groups: {foundation: \"*_base\"}}"},
    {"house",
     "{house: {length: 3 m, width: 2.4 m, height: 1.8 m, wall_thickness: 0.4 m, block: [0.6 m, 0.3 m]}, groups: "
     "{foundation: \"*_base\"}}"},
    {"rock",
     "{rock: {outline: [[0, 0], [12, 0], [12, 6], [3, 6]], width: 2 m, sets: [{dip: 0 deg, spacing: 2 m, origin: "
     "[0, 0, 0.5]}, {dip: 75 deg, dip_direction: 270 deg, spacing: 3 m}]}, groups: {foundation: {lowest: 0 %}}}"},
};

}  // namespace voussoir::app::patterns_test
