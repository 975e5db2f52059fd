// Damage to files, the same on every machine: for tests of readers that must survive it.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace voussoir
{

/// Damages texts and bytes. The same on every machine: the standard distributions are not.
class Damage
{
 public:
    explicit Damage(unsigned seed) : engine_(seed) {}

    std::string operator()(std::string content)
    {
        for (std::size_t times = 1 + below(3); times > 0; --times) damage(content);
        return content;
    }

    std::size_t below(std::size_t bound) { return bound == 0 ? 0 : engine_() % bound; }

 private:
    void damage(std::string& content)
    {
        switch (below(8)) {
            case 0:
                return flip(content);
            case 1:
                return content.resize(below(content.size() + 1));
            case 2:
                return repeat(content);
            case 3:
            case 4:
            case 5:
                return replace_number(content);
            case 6:
                return drop_line(content);
            default:
                return swap_lines(content);
        }
    }

    void flip(std::string& content)
    {
        if (!content.empty()) content[below(content.size())] ^= static_cast<char>(1U << below(8));
    }

    void repeat(std::string& content)
    {
        const std::size_t from = below(content.size());
        content.insert(below(content.size()), content.substr(from, 1 + below(200)));
    }

    void replace_number(std::string& content)
    {
        static const char* const bad[] = {"nan",         "inf", "1e308",       "-1",     "0",     "99999999999",
                                          "-2147483649", "",    "0.000000001", "1e-320", "1e999", "2147483647"};
        static const char* const digits = "0123456789";
        const std::size_t at = content.find_first_of(digits, below(content.size()));
        if (at == std::string::npos) return;
        const std::size_t end = content.find_first_not_of("0123456789.eE", at);
        content.replace(at, std::min(end, content.size()) - at, bad[below(std::size(bad))]);
    }

    /// Start and length, its end included, of a line taken at random.
    std::pair<std::size_t, std::size_t> any_line(const std::string& content)
    {
        const std::size_t inside = below(content.size());
        const std::size_t before = inside == 0 ? std::string::npos : content.rfind('\n', inside - 1);
        const std::size_t start = before == std::string::npos ? 0 : before + 1;
        const std::size_t end = std::min(content.find('\n', start), content.size());
        return {start, std::min(end + 1, content.size()) - start};
    }

    void drop_line(std::string& content)
    {
        const auto [start, length] = any_line(content);
        content.erase(start, length);
    }

    void swap_lines(std::string& content)
    {
        const auto [start, length] = any_line(content);
        const std::string line = content.substr(start, length);
        content.erase(start, length);
        content.insert(any_line(content).first, line);
    }

    std::mt19937 engine_;
};

/// The files of a folder by name.
inline std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

inline std::string content_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace voussoir
