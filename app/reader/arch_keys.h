// The keys that arches and bridges share.
#pragma once

#include "app/reader/pattern_keys.h"
#include "importers/patterns/arch_curve.h"

namespace voussoir::app::reader
{

/// `shape`, `span`, `rise` or `embrace`, `side_arc`, `thickness`, `springing_thickness` and `voussoirs`.
importers::patterns::ArchCurve read_arch_curve(YamlCursor& map);
/// The same of one arch of several: what `own` does not say, `common` says of all.
importers::patterns::ArchCurve read_arch_curve(YamlCursor& own, YamlCursor& common);

/// The same of half an arch: `span`, `rise` (by default the span), `thickness`, `springing_thickness`, `voussoirs`
/// of the half; `shape` circular or elliptic. @returns the whole arch
importers::patterns::ArchCurve read_half_arch_curve(YamlCursor& map);

}  // namespace voussoir::app::reader
