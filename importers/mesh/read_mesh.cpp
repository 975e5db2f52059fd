#include "importers/mesh/read_mesh.h"

#include <fstream>

#include "importers/mesh/file_kind.h"
#include "importers/mesh/formats.h"
#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

MeshFile read_kind(const FileKind& kind, const MeshSource& source, const ReadOptions& options)
{
    switch (kind.kind) {
        case Kind::obj:
            return read_obj(source, options);
        case Kind::stl:
            return read_stl(source);
        case Kind::ply:
            return read_ply(source);
        case Kind::off:
            return read_off(source);
        case Kind::gltf:
            return read_gltf(source);
        case Kind::compas:
            return read_compas(source);
        case Kind::collada:
            return read_collada(source);
        case Kind::archive:
            return read_3mf(source);
        case Kind::dxf:
            return read_dxf(source, options);
        case Kind::ifc:
            return read_ifc(source);
        case Kind::assimp:
            return read_assimp(source, kind.extension);
        case Kind::unknown:
            break;
    }
    throw InputError(source.place, "this is not a mesh file in a supported format",
                     "`voussoir import --formats` lists the supported formats");
}

/// @throws InputError when the reader that is asked for does not read such files
MeshFile read_by(MeshReader reader, const FileKind& kind, const MeshSource& source, const ReadOptions& options)
{
    const bool assimp_only = kind.kind == Kind::ifc || kind.kind == Kind::assimp;
    if (reader == MeshReader::own && assimp_only)
        throw InputError(source.place, "this format is read by assimp only (" + kind.extension + ")",
                         "leave out `--reader own`");
    if (reader != MeshReader::assimp || kind.kind == Kind::unknown) return read_kind(kind, source, options);
    if (kind.extension.empty())
        throw InputError(source.place, "assimp does not read this format", "leave out `--reader assimp`");
    return read_assimp(source, kind.extension);
}

/// What the file is, if its content tells, else its name; of archives the name tells what is packed in them.
FileKind judged(const FileKind& named, const FileKind& found)
{
    const bool packed = found.kind == Kind::archive && named.kind != Kind::unknown;
    return found.kind == Kind::unknown || packed ? named : found;
}

/// Whether what stands in an archive is a file of the format by itself: 3MF is an archive of its own kind.
bool is_packed(const MeshSource& source, const FileKind& kind)
{
    return source.bytes.starts_with("PK") &&
           (kind.kind == Kind::collada || kind.kind == Kind::ifc || kind.extension == "amf");
}

MeshFile read_source(MeshSource& source, const ReadOptions& options)
{
    std::vector<std::string> repairs;
    if (std::optional<std::string> text = text::from_utf16(source.bytes)) {
        source.bytes = std::move(*text);
        repairs.push_back("the text is UTF-16 and was read as such");
    }
    if (source.bytes.starts_with("\xEF\xBB\xBF")) source.bytes.erase(0, 3);
    refuse_known_strangers(source);
    const FileKind named = kind_by_name(source.path), found = kind_by_content(source.bytes);
    const FileKind kind = judged(named, found);
    if (is_packed(source, kind)) source = unpacked(source, "." + kind.extension);
    const bool other = named.kind != Kind::unknown && kind.kind != named.kind;
    if (other && !(kind.kind == Kind::gltf && named.kind == Kind::compas))
        repairs.push_back("the content does not match the file name, and was read by its own format");
    MeshFile mesh = read_by(options.reader, kind, source, options);
    mesh.repairs.insert(mesh.repairs.begin(), repairs.begin(), repairs.end());
    return mesh;
}

void merge_all(MeshFile& mesh, const std::string& name)
{
    PolygonSurface whole{name, {}, {}};
    for (const PolygonSurface& part : mesh.surfaces) append(part, whole);
    mesh.surfaces = {std::move(whole)};
}

}  // namespace

std::string read_bytes(const std::filesystem::path& file)
{
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        throw InputError(file.string(), "there is no such file", "give the path of a mesh file");
    if (!std::filesystem::is_regular_file(status))
        throw InputError(file.string(), "this is not a file", "give the path of a mesh file");
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(std::filesystem::file_size(file, error), '\0');
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        throw InputError(file.string(), "the file cannot be read", "check its permissions");
    if (bytes.empty()) throw InputError(file.string(), "the file is empty", "a mesh file has vertices and faces");
    return bytes;
}

MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options)
{
    MeshSource source{file, file.string(), text::as_utf8(file.stem().string()), read_bytes(file)};
    try {
        MeshFile mesh = read_source(source, options);
        if (options.stones == StonesBy::file) merge_all(mesh, source.name);
        for (std::string& repair : mesh.repairs) repair = text::as_utf8(repair);
        return mesh;
    } catch (InputError& error) {  // words of the file are quoted in faults: they must be text
        std::vector<Fault> faults = std::move(error.faults);
        for (Fault& fault : faults)
            fault = {text::as_utf8(fault.place), text::as_utf8(fault.found), text::as_utf8(fault.expected)};
        throw InputError(std::move(faults));
    }
}

}  // namespace voussoir::importers::mesh
