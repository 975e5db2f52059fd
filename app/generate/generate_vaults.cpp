#include "app/generate/generate_vaults.h"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <numbers>

#include "importers/patterns/survey.h"
#include "importers/patterns/vaults.h"
#include "libdda/errors.h"

namespace voussoir::app::generate
{
namespace
{

namespace patterns = importers::patterns;

constexpr double degree = std::numbers::pi / 180;

/// " --span 5", the shortest decimals that read back to the same bits.
std::string spelled(const std::string& flag, double number)
{
    std::array<char, 32> digits{};
    return " " + flag + " " +
           std::string(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

CLI::Option* add(CLI::App& command, const std::string& flag, double& number, const std::string& help)
{
    return command.add_option(flag, number, help)->capture_default_str();
}

CLI::Option* add(CLI::App& command, const std::string& flag, int& number, const std::string& help)
{
    return command.add_option(flag, number, help)->capture_default_str();
}

/// "5%", "5 %" or "0.05".
double share_from(const std::string& flag, std::string text)
{
    const bool percent = text.ends_with('%');
    if (percent) text.pop_back();
    while (text.ends_with(' ')) text.pop_back();
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        throw InputError(flag, "\"" + text + "\"", "give a share: 5% or 0.05");
    return percent ? number / 100 : number;
}

/// What a survey makes of the stones, as it is written on the command line.
struct SurveyOptions {
    std::string warp = "0", noise = "0", diagonals = "none";
    std::uint64_t seed = 1;

    void add_to(CLI::App& command)
    {
        command.add_option("--warp", warp, "corners of joints are moved by up to this share of the stones: 5%")
            ->capture_default_str();
        command.add_option("--noise", noise, "then each stone's own corners by up to this share of it: 0.1%")
            ->capture_default_str();
        command
            .add_option("--diagonals", diagonals,
                        "quadrilaterals as they are, or triangles: cut as in the neighbour, or at random")
            ->check(CLI::IsMember({"none", "shared", "random"}))
            ->capture_default_str();
        command.add_option("--seed", seed, "of all random numbers")->capture_default_str();
    }
    patterns::Survey survey() const
    {
        patterns::Survey asked;
        asked.seed = seed;
        asked.warp = share_from("--warp", warp);
        asked.noise = share_from("--noise", noise);
        asked.diagonals = diagonals == "random"   ? patterns::Diagonals::random
                          : diagonals == "shared" ? patterns::Diagonals::shared
                                                  : patterns::Diagonals::none;
        return asked;
    }
    std::string command_line() const
    {
        const patterns::Survey asked = survey();
        return spelled("--warp", asked.warp) + spelled("--noise", asked.noise) + " --diagonals " + diagonals +
               " --seed " + std::to_string(seed);
    }
};

/// A pattern with a survey of it.
class VaultCommand : public PatternCommand
{
 public:
    GeneratedMesh make() const override
    {
        return {patterns::surveyed(grid(), survey_.survey()), words() + survey_.command_line(), axes()};
    }

 protected:
    void add_survey(CLI::App& command) { survey_.add_to(command); }
    virtual patterns::StoneGrid grid() const = 0;
    virtual std::string words() const = 0;  ///< The sub-command with the pattern's own parameters.
    virtual std::string axes() const = 0;

 private:
    SurveyOptions survey_;
};

class DomeCommand : public VaultCommand
{
 public:
    explicit DomeCommand(CLI::App& command)
    {
        add(command, "--radius", dome_.radius, "of the intrados [m]");
        add(command, "--thickness", dome_.thickness, "[m]");
        add(command, "--oculus", oculus_, "from the axis to the last course's upper edge, at the centre [deg]");
        add(command, "--springing", springing_, "from the axis to the first course's bed, at the centre [deg]");
        add(command, "--courses", dome_.courses, "number of courses");
        add(command, "--stones", dome_.stones, "number in each course");
        add(command, "--support", dome_.support, "depth of the supports below the springing [m]");
        command.add_option("--bonded", dome_.bonded, "every other course is turned by half a stone")
            ->capture_default_str();
        command.add_option("--keystone", dome_.keystone, "one stone closes the oculus")->capture_default_str();
        add_survey(command);
    }

 protected:
    patterns::StoneGrid grid() const override
    {
        patterns::Dome asked = dome_;
        asked.oculus = oculus_ * degree;
        asked.springing = springing_ * degree;
        return patterns::dome(asked);
    }
    std::string words() const override
    {
        return "dome" + spelled("--radius", dome_.radius) + spelled("--thickness", dome_.thickness) +
               spelled("--oculus", oculus_) + spelled("--springing", springing_) +
               spelled("--courses", dome_.courses) + spelled("--stones", dome_.stones) +
               spelled("--support", dome_.support) + " --bonded " + (dome_.bonded ? "true" : "false") +
               " --keystone " + (dome_.keystone ? "true" : "false");
    }
    std::string axes() const override { return "Metres, z up along the axis, the springing at z = 0."; }

 private:
    patterns::Dome dome_;
    double oculus_ = 15, springing_ = 75;  // deg
};

class BarrelVaultCommand : public VaultCommand
{
 public:
    explicit BarrelVaultCommand(CLI::App& command)
    {
        add(command, "--span", vault_.span, "between the intrados springings [m]");
        add(command, "--rise", vault_.rise, "of the intrados [m]");
        add(command, "--thickness", vault_.thickness, "[m]");
        add(command, "--length", vault_.length, "across the span [m]");
        add(command, "--courses", vault_.courses, "number of courses, from springing to springing");
        add(command, "--stones", vault_.stones, "number along a course");
        add(command, "--support", vault_.support, "depth of the supports below the springing [m]");
        command.add_option("--bonded", vault_.bonded, "every other course begins with half a stone")
            ->capture_default_str();
        add_survey(command);
    }

 protected:
    patterns::StoneGrid grid() const override { return patterns::barrel_vault(vault_); }
    std::string words() const override
    {
        return "barrel-vault" + spelled("--span", vault_.span) + spelled("--rise", vault_.rise) +
               spelled("--thickness", vault_.thickness) + spelled("--length", vault_.length) +
               spelled("--courses", vault_.courses) + spelled("--stones", vault_.stones) +
               spelled("--support", vault_.support) + " --bonded " + (vault_.bonded ? "true" : "false");
    }
    std::string axes() const override
    {
        return "Metres, z up, x along the span, y along the vault, the springings at z = 0.";
    }

 private:
    patterns::BarrelVault vault_;
};

class CrossVaultCommand : public VaultCommand
{
 public:
    explicit CrossVaultCommand(CLI::App& command)
    {
        add(command, "--span", vault_.span, "of the side arches, between the intrados springings [m]");
        add(command, "--rise", vault_.rise, "of the intrados [m]");
        add(command, "--thickness", vault_.thickness, "[m]");
        add(command, "--margin", vault_.margin, "from the outermost extrados to the side of the bay [m]");
        add(command, "--courses", vault_.courses, "number of courses, from springing to crown");
        add(command, "--stones", vault_.stones, "number along the crown, from the centre to the side");
        add(command, "--support", vault_.support, "depth of the supports below the springing [m]");
        add_survey(command);
    }

 protected:
    patterns::StoneGrid grid() const override { return patterns::cross_vault(vault_); }
    std::string words() const override
    {
        return "cross-vault" + spelled("--span", vault_.span) + spelled("--rise", vault_.rise) +
               spelled("--thickness", vault_.thickness) + spelled("--margin", vault_.margin) +
               spelled("--courses", vault_.courses) + spelled("--stones", vault_.stones) +
               spelled("--support", vault_.support);
    }
    std::string axes() const override
    {
        return "Metres, z up, the middle of the bay at x = y = 0, the springings at z = 0.";
    }

 private:
    patterns::CrossVault vault_;
};

}  // namespace

std::unique_ptr<PatternCommand> add_dome_options(CLI::App& command)
{
    return std::make_unique<DomeCommand>(command);
}

std::unique_ptr<PatternCommand> add_barrel_vault_options(CLI::App& command)
{
    return std::make_unique<BarrelVaultCommand>(command);
}

std::unique_ptr<PatternCommand> add_cross_vault_options(CLI::App& command)
{
    return std::make_unique<CrossVaultCommand>(command);
}

}  // namespace voussoir::app::generate
