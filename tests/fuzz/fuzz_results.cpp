// A libFuzzer target: what is read back from earlier runs. Inputs whose first byte is even are edits of a small
// results file (see damaged_results.h); HDF5 itself, which is not ours and does not survive every damage, reads
// files of others only in a child. Inputs whose first byte is odd are states, or restarts of a small tower, to
// which the mark and the checksum are given.

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/results/packed.h"
#include "app/results/restart_file.h"
#include "app/results/state_file.h"
#include "app/words/diagnosis_words.h"
#include "libdda/errors.h"
#include "tests/app/results/synthetic.h"
#include "tests/fuzz/damaged_results.h"
#include "tests/temporary_folder.h"

namespace
{

using namespace voussoir;
using namespace voussoir::app;
using namespace voussoir::app::results;
namespace fs = std::filesystem;

/// What a file begins with, up to its first line end.
std::string mark_of(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::string mark;
    std::getline(stream, mark);
    return mark + "\n";
}

std::string mark_of_states(const fs::path& folder)
{
    save_state(State{}, folder / "empty");
    return mark_of(folder / "empty");
}

std::string mark_of_restarts(const fs::path& folder)
{
    save_restart(Restart{}, folder / "empty");
    return mark_of(folder / "empty");
}

/// With mark and checksum. Not synced to the disk as the program's own files are: that takes milliseconds.
void seal(const fs::path& path, const std::string& mark, const std::string& payload)
{
    Packer tail;
    tail.field(fnv1a(payload));
    std::ofstream(path, std::ios::binary) << mark << payload << tail.bytes;
}

void check_points(const State& state)
{
    for (const ContactPatch& patch : state.contacts.patches)
        for (int i = 0; i < patch.point_count; ++i)
            if (state.contacts.points[patch.first_point + i].status > ContactStatus::sliding) std::abort();
}

void read_state(const fs::path& folder, const std::string& payload)
{
    static const std::string mark = mark_of_states(folder);
    seal(folder / "state", mark, payload);
    const State state = load_state(folder / "state");
    check_points(state);
    check_fits(state, Model{}, folder / "state");
}

void read_restart(const fs::path& folder, const std::string& payload)
{
    static const std::string mark = mark_of_restarts(folder);
    static const Case tower = synthetic::tower(Kinematics::spatial_rigid, 1);
    seal(folder / "restart", mark, payload);
    const Restart restart = load_restart(folder / "restart");
    check_points(restart.state);
    check_fits(restart, tower, folder / "restart");
    words::message_of(restart.position.report, tower.model, tower.stages);
    words::warnings_of(restart.position.report, tower.model, tower.stages);
    if (restart.ended) return;
    // What a run looks up.
    tower.stages.at(static_cast<std::size_t>(restart.state.stage));
    for (const FallenBlock& fallen : restart.position.report.fallen) tower.model.blocks.at(fallen.block);
    for (const ContactPatch& patch : restart.state.contacts.patches)
        tower.model.blocks.at(patch.block_a).parts.at(patch.part_a);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    if (size == 0) return 0;
    const std::string rest(reinterpret_cast<const char*>(data + 1), size - 1);
    try {
        if (data[0] % 2 == 1) {
            data[0] % 4 == 3 ? read_restart(folder, rest) : read_state(folder, rest);
            return 0;
        }
        DraftResults draft = two_boxes(data[0] % 4 == 2);
        edit(rest, draft);
        write_draft(draft, folder / "results.h5");
        read_everything(folder / "results.h5");
    } catch (const InputError&) {
    }
    return 0;
}
