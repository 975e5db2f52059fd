#include "app/results/state_file.h"

#include "app/results/packed.h"
#include "app/results/state_checks.h"
#include "app/results/state_fields.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{

namespace
{
constexpr std::string_view mark = "voussoir state 6\n";  // its digit rises when the layout changes
}

void save_state(const State& state, const std::filesystem::path& path)
{
    Packer packer;
    state_fields(packer, state);
    write_packed(path, mark, packer.bytes);
}

State load_state(const std::filesystem::path& path)
{
    const std::string payload = read_packed(path, mark, "a state file");
    Unpacker unpacker(payload);
    State state;
    state_fields(unpacker, state);
    if (!unpacker.done() || !is_sound(state)) refuse_damaged(path);
    return state;
}

void check_fits(const State& state, const Model& model, const std::filesystem::path& path)
{
    if (!fits(state, model)) throw InputError(path.string(), "the state of another model", "start the run again");
}

}  // namespace voussoir::app::results
