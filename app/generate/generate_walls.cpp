#include "app/generate/generate_walls.h"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <numbers>

#include "importers/patterns/house.h"
#include "importers/patterns/wall.h"
#include "libdda/errors.h"

namespace voussoir::app::generate
{
namespace
{

using Numbers = std::vector<double>;

/// " --block 0.6,0.3", the shortest decimals that read back to the same bits; nothing for an empty list.
std::string spelled(const std::string& flag, const Numbers& numbers)
{
    if (numbers.empty()) return {};
    std::string text = " " + flag + " ";
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), numbers[i]).ptr;
        text += (i == 0 ? "" : ",") + std::string(digits.data(), end);
    }
    return text;
}

std::vector<importers::mesh::PolygonSurface> surfaces_of(
    const std::vector<importers::patterns::MasonryBlock>& blocks)
{
    std::vector<importers::mesh::PolygonSurface> surfaces;
    surfaces.reserve(blocks.size());
    for (const importers::patterns::MasonryBlock& block : blocks)
        surfaces.push_back(importers::patterns::to_surface(block));
    return surfaces;
}

std::vector<importers::patterns::Opening> openings_from(const std::string& flag, const Numbers& numbers)
{
    if (numbers.size() % 4 != 0)
        throw InputError(flag, std::to_string(numbers.size()) + " numbers",
                         "give AT,SILL,WIDTH,HEIGHT of each opening");
    std::vector<importers::patterns::Opening> openings;
    for (std::size_t i = 0; i < numbers.size(); i += 4)
        openings.push_back({numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3]});
    return openings;
}

CLI::Option* add_list(CLI::App& command, const std::string& flag, Numbers& numbers, int least, int most,
                      const std::string& help)
{
    return command.add_option(flag, numbers, help)->delimiter(',')->expected(least, most)->capture_default_str();
}

constexpr int max_numbers = 4000;  // of all openings of a wall

/// What the two have in common, as it is written on the command line.
struct CommonOptions {
    Numbers block{0.6, 0.3}, lintel{0.3, 0.3}, base, origin{0, 0, 0};
    double direction = 0;  // deg
    importers::patterns::Imperfection imperfection;

    void add_to(CLI::App& command)
    {
        add_list(command, "--block", block, 2, 2, "LENGTH,HEIGHT of a block [m]");
        add_list(command, "--lintel", lintel, 2, 2, "HEIGHT,BEARING of the lintels over openings [m]");
        add_list(command, "--base", base, 2, 2, "HEIGHT,PROJECTION of the slab underneath [m]; height 0: none");
        add_list(command, "--origin", origin, 3, 3, "X,Y,Z of the outer lower corner [m]");
        command.add_option("--direction", direction, "of the first wall, from x to y [deg]")
            ->capture_default_str();
        command.add_option("--seed", imperfection.seed, "of the imperfections")->capture_default_str();
        command.add_option("--size", imperfection.size, "blocks are smaller by up to this fraction [-]")
            ->capture_default_str();
        command.add_option("--joint", imperfection.joint, "blocks are moved by up to this length [m]")
            ->capture_default_str();
    }
    template <class Pattern>
    void apply_to(Pattern& pattern) const
    {
        pattern.block_length = block[0];
        pattern.block_height = block[1];
        pattern.lintel = {lintel[0], lintel[1]};
        if (!base.empty()) pattern.base = {base[0], base[1]};
        pattern.placement = {{origin[0], origin[1], origin[2]}, direction * std::numbers::pi / 180};
        pattern.imperfection = imperfection;
    }
    std::string command_line() const
    {
        return spelled("--block", block) + spelled("--lintel", lintel) + spelled("--base", base) +
               spelled("--origin", origin) + spelled("--direction", {direction}) + " --seed " +
               std::to_string(imperfection.seed) + spelled("--size", {imperfection.size}) +
               spelled("--joint", {imperfection.joint});
    }
};

class WallCommand : public PatternCommand
{
 public:
    explicit WallCommand(CLI::App& command)
    {
        command.add_option("--name", wall_.name, "first part of the blocks' names")->capture_default_str();
        command.add_option("--length", wall_.length, "along x [m]")->capture_default_str();
        command.add_option("--height", wall_.height, "[m]")->capture_default_str();
        command.add_option("--thickness", wall_.thickness, "[m]")->capture_default_str();
        command.add_option("--leaves", wall_.leaves, "side by side through the thickness")->capture_default_str();
        command.add_option("--header-every", wall_.header_every, "every n-th course extends through all leaves")
            ->capture_default_str();
        add_list(command, "--opening", openings_, 4, max_numbers,
                 "AT,SILL,WIDTH,HEIGHT of an opening [m]; repeat");
        common_.base = {0, 0};
        common_.add_to(command);
    }
    GeneratedMesh make() const override
    {
        importers::patterns::Wall asked = wall_;
        asked.openings = openings_from("--opening", openings_);
        common_.apply_to(asked);
        const std::string command =
            "wall --name " + wall_.name + spelled("--length", {wall_.length}) +
            spelled("--height", {wall_.height}) + spelled("--thickness", {wall_.thickness}) + " --leaves " +
            std::to_string(wall_.leaves) + " --header-every " + std::to_string(wall_.header_every) +
            spelled("--opening", openings_) + common_.command_line();
        return {surfaces_of(importers::patterns::wall(asked)), command,
                "Metres, z up, the foot of the wall at z = 0."};
    }

 private:
    importers::patterns::Wall wall_;
    Numbers openings_;
    CommonOptions common_;
};

class HouseCommand : public PatternCommand
{
 public:
    explicit HouseCommand(CLI::App& command)
    {
        command.add_option("--name", house_.name, "first part of the blocks' names")->capture_default_str();
        command.add_option("--length", house_.length, "outside, along x [m]")->capture_default_str();
        command.add_option("--width", house_.width, "outside, along y [m]")->capture_default_str();
        command.add_option("--height", house_.height, "[m]")->capture_default_str();
        command.add_option("--wall-thickness", house_.wall_thickness, "[m]")->capture_default_str();
        for (std::size_t side = 0; side < importers::patterns::side_names.size(); ++side)
            add_list(command, flag(side), openings_[side], 4, max_numbers,
                     std::string("AT,SILL,WIDTH,HEIGHT of an opening in the ") +
                         importers::patterns::side_names[side] + " wall [m]; repeat");
        common_.base = {house_.base.height, house_.base.projection};
        common_.add_to(command);
    }
    GeneratedMesh make() const override
    {
        importers::patterns::House asked = house_;
        common_.apply_to(asked);
        std::string command = "house --name " + house_.name + spelled("--length", {house_.length}) +
                              spelled("--width", {house_.width}) + spelled("--height", {house_.height}) +
                              spelled("--wall-thickness", {house_.wall_thickness});
        for (std::size_t side = 0; side < importers::patterns::side_names.size(); ++side) {
            for (const importers::patterns::Opening& opening : openings_from(flag(side), openings_[side]))
                asked.openings.push_back({static_cast<importers::patterns::Side>(side), opening});
            command += spelled(flag(side), openings_[side]);
        }
        return {surfaces_of(importers::patterns::house(asked)), command + common_.command_line(),
                "Metres, z up, the foot of the walls at z = 0."};
    }

 private:
    static std::string flag(std::size_t side) { return std::string("--") + importers::patterns::side_names[side]; }

    importers::patterns::House house_;
    std::array<Numbers, 4> openings_;
    CommonOptions common_;
};

}  // namespace

std::unique_ptr<PatternCommand> add_wall_options(CLI::App& command)
{
    return std::make_unique<WallCommand>(command);
}

std::unique_ptr<PatternCommand> add_house_options(CLI::App& command)
{
    return std::make_unique<HouseCommand>(command);
}

}  // namespace voussoir::app::generate
