// Accelerograms for programs that read them with voussoir::records: what is included here, and what that includes,
// is installed.
#pragma once

#include "records/measures/measures.h"
#include "records/measures/response_spectrum.h"
#include "records/processing/processing.h"
#include "records/record.h"
#include "records/write_at2.h"
