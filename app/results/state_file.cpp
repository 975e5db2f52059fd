#include "app/results/state_file.h"

#include <bit>
#include <cstring>
#include <string_view>

#include "app/results/atomic_file.h"
#include "libdda/errors.h"

namespace voussoir
{

static_assert(std::endian::native == std::endian::little, "state files are little-endian");

namespace
{

// Mark, payload, FNV-1a of the payload. The mark's digit rises when the layout changes.
constexpr std::string_view mark = "voussoir state 2\n";
constexpr std::size_t hash_bytes = 8;

std::uint64_t fnv1a(std::string_view bytes)
{
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
    return hash;
}

class Packer
{
 public:
    template <typename T>
    void field(const T& value)
    {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
    }
    template <int D>
    void field(const Eigen::Matrix<double, D, 1>& v)
    {
        for (int i = 0; i < D; ++i) field(v[i]);
    }
    template <typename T>
    void size_of(const std::vector<T>& list)
    {
        field(static_cast<std::uint64_t>(list.size()));
    }
    std::string bytes;
};

/// Reads what Packer wrote. Never past the end: `whole` turns false instead.
class Unpacker
{
 public:
    explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
    template <typename T>
    void field(T& value)
    {
        whole = whole && bytes_.size() >= sizeof(T);
        if (!whole) return;
        std::memcpy(&value, bytes_.data(), sizeof(T));
        bytes_.remove_prefix(sizeof(T));
    }
    void field(bool& value)
    {
        char byte = 0;
        field(byte);
        value = byte != 0;
    }
    template <int D>
    void field(Eigen::Matrix<double, D, 1>& v)
    {
        for (int i = 0; i < D; ++i) field(v[i]);
    }
    template <typename T>
    void size_of(std::vector<T>& list)
    {
        std::uint64_t size = 0;
        field(size);
        whole = whole && size <= bytes_.size();  // an entry takes more than a byte: no absurd allocation
        if (whole) list.resize(size);
    }
    bool done() const { return whole && bytes_.empty(); }
    bool whole = true;

 private:
    std::string_view bytes_;
};

/// One list of fields for both directions, so that they cannot disagree.
template <typename Archive, typename Patch>
void patch_fields(Archive& archive, Patch& patch)
{
    archive.field(patch.block_a);
    archive.field(patch.block_b);
    archive.field(patch.part_a);
    archive.field(patch.part_b);
    archive.field(patch.feature_a);
    archive.field(patch.feature_b);
    archive.field(patch.edge_edge);
    archive.field(patch.intact);
    archive.field(patch.stiffness);
    archive.field(patch.normal);
    archive.field(patch.first_point);
    archive.field(patch.point_count);
}

template <typename Archive, typename Point>
void point_fields(Archive& archive, Point& point)
{
    archive.field(point.feature);
    archive.field(point.status);
    archive.field(point.gap);
    archive.field(point.area);
    archive.field(point.normal_force);
    archive.field(point.position);
    archive.field(point.shear_force);
    archive.field(point.elastic_slip);
    archive.field(point.plastic_slip);
}

template <typename Archive, typename Contacts>
void contact_fields(Archive& archive, Contacts& contacts)
{
    archive.size_of(contacts.patches);
    for (auto& patch : contacts.patches) patch_fields(archive, patch);
    archive.size_of(contacts.points);
    for (auto& point : contacts.points) point_fields(archive, point);
}

template <typename Archive, typename SomeState>
void state_fields(Archive& archive, SomeState& state)
{
    archive.field(state.time);
    archive.field(state.step);
    archive.field(state.stage);
    archive.field(state.stage_time);
    archive.field(state.grid);
    archive.field(state.next_time_step);
    for (auto* list : {&state.coordinates, &state.velocities, &state.foundation_anchors}) {
        archive.size_of(*list);
        for (auto& value : *list) archive.field(value);
    }
    contact_fields(archive, state.contacts);
    contact_fields(archive, state.planar_contacts);
}

}  // namespace

void save_state(const State& state, const std::filesystem::path& path)
{
    Packer payload, tail;
    state_fields(payload, state);
    tail.field(fnv1a(payload.bytes));
    write_atomically(path, std::string(mark) + payload.bytes + tail.bytes);
}

State load_state(const std::filesystem::path& path)
{
    const std::string file = read_whole_file(path);
    const std::string_view bytes = file;
    if (bytes.substr(0, mark.size()) != mark || bytes.size() < mark.size() + hash_bytes) {
        throw InputError(path.string(), "not a state file of this version of voussoir",
                         "give a state file that this version wrote");
    }
    const std::string_view payload = bytes.substr(mark.size(), bytes.size() - mark.size() - hash_bytes);
    std::uint64_t hash = 0;
    std::memcpy(&hash, bytes.data() + bytes.size() - hash_bytes, hash_bytes);
    State state;
    Unpacker unpacker(payload);
    if (hash == fnv1a(payload)) state_fields(unpacker, state);
    if (hash != fnv1a(payload) || !unpacker.done()) {
        throw InputError(path.string(), "damaged: its checksum does not fit", "start the run anew");
    }
    return state;
}

}  // namespace voussoir
