// The formats of mesh files, and by whom each is read.
#pragma once

#include <string>
#include <vector>

namespace voussoir::importers::mesh
{

/// Who reads a file: our own reader where there is one, else assimp; or one of them in any case.
enum class MeshReader { automatic, own, assimp };

/// A format of mesh files, and who reads it.
struct MeshFormat {
    std::string name;                     // as people call it
    std::vector<std::string> extensions;  // without the point, lower case
    bool own = false;                     // read by a reader written here, else by assimp
    std::string lost;                     // what is lost on reading, in words; empty: nothing
};

/// Those with readers of our own first, then all that the assimp of this machine reads besides.
std::vector<MeshFormat> mesh_formats();

}  // namespace voussoir::importers::mesh
