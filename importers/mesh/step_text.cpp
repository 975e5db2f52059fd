#include "importers/mesh/step_text.h"

#include <algorithm>
#include <unordered_map>

#include "importers/mesh/text.h"

namespace voussoir::importers::mesh
{

namespace
{

/// `#7 = NAME(#1, #2);`
struct Entity {
    std::vector<long long> named;
    std::size_t at = 0;  // byte of the file
};

using Entities = std::unordered_map<long long, Entity>;

class StepScanner
{
 public:
    explicit StepScanner(const MeshSource& source) : source_(source), text_(source.bytes) {}

    Entities scan()
    {
        const std::size_t data = text_.find("DATA;");
        if (data == std::string_view::npos || text_.find("END-ISO-10303-21") == std::string_view::npos)
            throw InputError(source_.place, "the file does not end with END-ISO-10303-21", "the file was cut off");
        at_ = data + 5;
        while (skip_blanks(), at_ < text_.size() && text_[at_] == '#') read_entity();
        if (!text_.substr(at_).starts_with("ENDSEC"))
            refuse(at_, "this is no statement", "write `#7 = NAME(...);`");
        return std::move(entities_);
    }

    [[noreturn]] void refuse(std::size_t at, const std::string& found, const std::string& expected) const
    {
        throw InputError(line_place(source_.place, text_, static_cast<std::ptrdiff_t>(at)), found, expected);
    }

 private:
    void skip_blanks()
    {
        while (at_ < text_.size()) {
            if (text_.substr(at_).starts_with("/*"))
                at_ = std::min(text_.find("*/", at_), text_.size() - 2) + 2;
            else if (text_.find_first_not_of(" \t\r\n", at_) != at_)
                at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
            else
                return;
        }
    }

    long long read_number()
    {
        const std::size_t end = std::min(text_.find_first_not_of("0123456789", ++at_), text_.size());
        const std::optional<long long> number = text::parse_integer(text_.substr(at_, end - at_));
        if (!number) refuse(at_, "a \"#\" is not followed by a number", "the file is damaged");
        at_ = end;
        return *number;
    }

    void read_entity()
    {
        const std::size_t start = at_;
        Entity entity{{}, at_};
        const long long number = read_number();
        const auto expect = [&](bool good) {
            if (!good)
                refuse(start, "statement #" + std::to_string(number) + " is not whole", "write `#7 = NAME(...);`");
        };
        skip_blanks();
        expect(at_ < text_.size() && text_[at_++] == '=');
        int depth = 0, lists = 0;
        for (skip_blanks(); at_ < text_.size() && text_[at_] != ';'; skip_blanks()) {
            const char c = text_[at_];
            if (c == '\'') {
                expect((at_ = text_.find('\'', at_ + 1)) != std::string_view::npos);
            } else if (c == '#') {
                entity.named.push_back(read_number());
                continue;
            }
            depth += (c == '(') - (c == ')');
            lists += c == '(';
            expect(depth >= 0);
            ++at_;
        }
        expect(at_ < text_.size() && depth == 0 && lists > 0);
        ++at_;
        if (!entities_.emplace(number, std::move(entity)).second)
            refuse(start, "#" + std::to_string(number) + " is defined twice", "numbers are unique");
    }

    const MeshSource& source_;
    std::string_view text_;
    std::size_t at_ = 0;
    Entities entities_;
};

/// Takes away what names nothing that is left, again and again; what remains goes in circles.
void check_no_circles(const Entities& entities, const StepScanner& scanner)
{
    std::unordered_map<long long, std::size_t> left;
    std::unordered_map<long long, std::vector<long long>> named_by;
    std::vector<long long> free;
    for (const auto& [number, entity] : entities) {
        left[number] = entity.named.size();
        if (entity.named.empty()) free.push_back(number);
        for (const long long other : entity.named) named_by[other].push_back(number);
    }
    std::size_t taken = 0;
    for (; !free.empty(); ++taken) {
        const long long number = free.back();
        free.pop_back();
        for (const long long user : named_by[number])
            if (--left[user] == 0) free.push_back(user);
    }
    if (taken == entities.size()) return;
    const Entity* first = nullptr;
    for (const auto& [number, entity] : entities)
        if (left[number] > 0 && (first == nullptr || entity.at < first->at)) first = &entity;
    scanner.refuse(first->at, "what is defined here is made of itself", "definitions must not go in circles");
}

}  // namespace

void check_step_text(const MeshSource& source)
{
    StepScanner scanner(source);
    const Entities entities = scanner.scan();
    for (const auto& [number, entity] : entities)
        for (const long long other : entity.named)
            if (!entities.contains(other))
                scanner.refuse(entity.at, "it names #" + std::to_string(other),
                               "there is no such definition in the file");
    check_no_circles(entities, scanner);
}

}  // namespace voussoir::importers::mesh
