// Stones for programs that import them with voussoir::importers: what is included here, and what that includes, is
// installed.
#pragma once

#include "importers/exact/certify.h"
#include "importers/exact/decompose.h"
#include "importers/mesh/read_mesh.h"
#include "importers/mesh/write_obj.h"
#include "importers/patterns/arch_bridge.h"
#include "importers/patterns/house.h"
#include "importers/patterns/wall.h"
