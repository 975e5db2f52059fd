#include <cmath>
#include <cstdint>

#include "importers/mesh/formats.h"
#include "libdda/errors.h"

namespace voussoir
{

namespace
{

constexpr int editor = 0x3D3D, object = 0x4000, mesh = 0x4100, vertices = 0x4110, faces = 0x4120;

/// A file of nested chunks: a number for their kind, their length, their content. Coordinates are those of the
/// world: the matrix of a mesh (0x4160) only says where its own axes were.
class ChunkReader
{
 public:
    explicit ChunkReader(const MeshSource& source) : source_(source), result_(source) {}

    MeshFile read()
    {
        read_chunks(6, end_of(0), 0);
        return result_.finish();
    }

 private:
    /// Where the chunk at a byte ends. @throws InputError when that is not within the file
    std::size_t end_of(std::size_t at) const
    {
        const std::size_t length = load<std::uint32_t>(&source_.bytes[at + 2]);
        if (length < 6 || length > source_.bytes.size() - at)
            throw InputError(source_.place,
                             "the chunk at byte " + std::to_string(at) + " is " + std::to_string(length) +
                                 " bytes long, but the file has " + std::to_string(source_.bytes.size()),
                             "the file was cut off or damaged");
        return at + length;
    }

    void read_chunks(std::size_t at, std::size_t end, int depth)
    {
        while (at + 6 <= end) {
            const std::size_t next = end_of(at);
            if (next > end) reaches_beyond(at);
            const int kind = load<std::uint16_t>(&source_.bytes[at]);
            if (kind == object && depth == 1) read_object(at + 6, next);
            if (kind == editor && depth == 0) read_chunks(at + 6, next, depth + 1);
            if (kind == mesh && depth == 2) read_mesh_chunk(at + 6, next);
            at = next;
        }
    }

    [[noreturn]] void reaches_beyond(std::size_t at) const
    {
        throw InputError(source_.place,
                         "the chunk at byte " + std::to_string(at) + " reaches beyond the one it is in",
                         "the file is damaged");
    }

    void read_object(std::size_t at, std::size_t end)
    {
        const std::size_t name_end = source_.bytes.find('\0', at);
        if (name_end >= end) reaches_beyond(at);
        name_ = source_.bytes.substr(at, name_end - at);
        read_chunks(name_end + 1, end, 2);
    }

    void read_mesh_chunk(std::size_t at, std::size_t end)
    {
        PolygonSurface surface{name_, {}, {}};
        while (at + 6 <= end) {
            const std::size_t next = end_of(at);
            const int kind = load<std::uint16_t>(&source_.bytes[at]);
            if (next > end) reaches_beyond(at);
            if (kind == vertices || kind == faces) {
                const std::size_t entry = kind == vertices ? 12 : 8;
                if (next - at < 8) reaches_beyond(at);
                const std::size_t count = load<std::uint16_t>(&source_.bytes[at + 6]);
                if (count * entry > next - at - 8) reaches_beyond(at);
                for (std::size_t i = 0; i < count; ++i)
                    read_entry(&source_.bytes[at + 8 + i * entry], kind, surface);
            }
            at = next;
        }
        result_.add(std::move(surface));
    }

    static void read_entry(const char* at, int kind, PolygonSurface& surface)
    {
        if (kind == vertices)
            surface.vertices.emplace_back(load<float>(at), load<float>(at + 4), load<float>(at + 8));
        else
            surface.faces.push_back(
                {load<std::uint16_t>(at), load<std::uint16_t>(at + 2), load<std::uint16_t>(at + 4)});
    }

    const MeshSource& source_;
    SurfaceList result_;
    std::string name_;
};

}  // namespace

MeshFile read_3ds(const MeshSource& source)
{
    if (source.bytes.size() < 6) throw InputError(source.place, "this is no 3DS file", "the file was cut off");
    return ChunkReader(source).read();
}

}  // namespace voussoir
