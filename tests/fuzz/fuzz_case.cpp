// A libFuzzer target: any bytes, read as a case file. InputError is what reading may answer; all else is a
// finding.
//
// Comments "#--set key=value" at the beginning of the input are given as settings of the command line. The case
// lies in a folder with two records; its meshes are not read but answered by import_geometry below, in this
// process: what reads meshes is another target, and a child for every input would be slow.

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "importers/helper/geometry.h"
#include "libdda/errors.h"
#include "tests/fuzz/accepted_case.h"
#include "tests/temporary_folder.h"

namespace
{

using namespace voussoir;
using namespace voussoir::app;
using namespace voussoir::importers::helper;
namespace fs = std::filesystem;

/// Where the cases lie, beside two records; the meshes are not read.
struct CaseFolder : TemporaryFolder {
    CaseFolder()
    {
        for (const char* seed : {"peer_npts.at2", "eqsig.txt"})
            fs::copy_file(fs::path(VOUSSOIR_FUZZ_SEEDS) / "records" / seed, path() / seed);
        for (const char* mesh : {"stones.obj", "refused.obj", "overlapping.obj"}) write(mesh, "");
    }
};

/// Could the text name a file outside the folder? A slash after a letter or digit divides units or leads down.
bool leads_out(const std::string& text)
{
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '/' && (i == 0 || std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0)) return true;
    for (const char* way : {"..", "\\x2", "\\u002", "\\U0000002"})
        if (text.find(way) != std::string::npos) return true;
    return false;
}

std::vector<std::string> settings_of(const std::string& text)
{
    const std::string mark = "#--set ";
    std::vector<std::string> settings;
    for (std::size_t at = 0; settings.size() < 4 && text.compare(at, mark.size(), mark) == 0;) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        settings.push_back(text.substr(at + mark.size(), end - at - mark.size()));
        at = std::min(end + 1, text.size());
    }
    return settings;
}

Stone cube(const std::string& name, double z)
{
    Stone stone;
    stone.name = name;
    stone.closed = stone.convex = true;
    stone.parts = {make_box({0, 0, z}, {1, 1, z + 1})};
    stone.moments = moments_of(stone.parts);
    return stone;
}

/// As the helper places stones; what is no stone then is refused.
void place(Stone& stone, const PlacedCopy& copy, ImportedMesh& mesh)
{
    stone.name += copy.suffix;
    try {
        for (ConvexPolyhedron& part : stone.parts) part = placed(std::move(part), copy, stone.name);
        stone.moments = moments_of(stone.parts);
    } catch (const InputError& error) {
        stone.reason = error.what();
        stone.parts.clear();
    }
    mesh.stones.push_back(std::move(stone));
}

}  // namespace

namespace voussoir::importers::helper
{

Geometry import_geometry(const std::vector<MeshRequest>& requests, const GeometryLimits&)
{
    Geometry geometry;
    for (const MeshRequest& request : requests) {
        ImportedMesh& mesh = geometry.meshes.emplace_back();
        mesh.file = request.file.string();
        for (const PlacedCopy& copy : request.copies.empty() ? std::vector<PlacedCopy>(1) : request.copies)
            for (Stone stone : {cube("base", 0), cube("stone_1", 1), cube("stone_2", 2)}) place(stone, copy, mesh);
        if (request.file.filename() == "refused.obj") mesh.stones.back().reason = "a stone that is not closed";
        for (const Stone& stone : mesh.stones)
            if (!stone.reason.empty()) mesh.reason = stone.reason;
        mesh.accepted = mesh.reason.empty();
        if (request.file.filename() == "overlapping.obj")
            geometry.overlaps.push_back({"stone_1", "stone_2", 1e-3, 1e-3});
    }
    return geometry;
}

}  // namespace voussoir::importers::helper

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const CaseFolder folder;
    const std::string text(reinterpret_cast<const char*>(data), size);
    if (leads_out(text)) return -1;
    const fs::path file = folder / "case.yaml";
    std::ofstream(file, std::ios::binary) << text;
    try {
        check_accepted(reader::read_case(file, settings_of(text)));
    } catch (const InputError& error) {
        if (error.faults.empty()) std::abort();
        for (const Fault& fault : error.faults)
            if (fault.found.empty() || fault.expected.empty()) std::abort();
    }
    return 0;
}
