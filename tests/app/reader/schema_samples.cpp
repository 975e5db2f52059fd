#include "tests/app/reader/schema_samples.h"

#include <algorithm>
#include <fstream>
#include <random>
#include <regex>

namespace voussoir::app::reader
{
namespace
{

using nlohmann::json;

bool is_deprecated(const json& schema)
{
    return schema.value("deprecated", false);
}

std::string as_word(const json& value)
{
    return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string below(const std::string& path, const std::string& key)
{
    return path.empty() ? key : path + "." + key;
}

/// Walks through a schema, or makes samples of it.
class Schema
{
 public:
    explicit Schema(const json& whole) : whole_(whole) {}

    void gather(const json& part, const std::string& path, SchemaWords& found) const
    {
        const json& schema = resolved(part);
        if (schema.contains("examples")) return;  // a number with its unit: neither keys nor words
        for (const json& alternative : alternatives(schema)) gather(alternative, path, found);
        const json properties = schema.value("properties", json::object());
        for (const auto& [key, value] : properties.items()) {
            (is_deprecated(value) ? found.deprecated : found.keys)[path].insert(key);
            gather(value, below(path, key), found);
        }
        const json others = schema.value("additionalProperties", json());
        if (others.is_object()) gather(others, path + ".*", found);
        if (schema.contains("items")) gather(schema.at("items"), path + "[]", found);
        if (schema.value("type", json()) == "boolean") found.words[path] = {"false", "true"};
        if (schema.contains("const")) found.words[path].insert(as_word(schema.at("const")));
        for (const json& word : schema.value("enum", json::array())) found.words[path].insert(as_word(word));
    }

    /// @param key where the value stands, for a text that fits. Never empty
    std::vector<json> samples(const json& part, const std::string& key, bool with_deprecated) const
    {
        if (part.value("$ref", "") == "#/$defs/quantity") return {1};
        const json& schema = resolved(part);
        if (schema.contains("examples")) return schema.at("examples").get<std::vector<json>>();
        if (schema.contains("const")) return {schema.at("const")};
        if (schema.contains("enum")) return schema.at("enum").get<std::vector<json>>();
        if (schema.contains("properties")) return objects(schema, with_deprecated);
        std::vector<json> all;
        for (const json& alternative : alternatives(schema))
            for (const json& sample : samples(alternative, key, with_deprecated)) all.push_back(sample);
        if (!all.empty()) return all;
        if (schema.contains("additionalProperties")) return {named(schema, with_deprecated)};
        if (schema.contains("items")) return lists(schema, key, with_deprecated);
        return scalars(schema, key);
    }

 private:
    const json& resolved(const json& part) const
    {
        const std::string reference = part.value("$ref", "");
        return reference.empty() ? part : whole_.at(json::json_pointer(reference.substr(1)));
    }

    /// Those of oneOf and anyOf that are more than conditions.
    static std::vector<json> alternatives(const json& schema)
    {
        std::vector<json> found;
        for (const char* word : {"oneOf", "anyOf"})
            for (const json& alternative : schema.value(word, json::array()))
                if (!alternative.contains("required") || alternative.contains("properties"))
                    found.push_back(alternative);
        return found;
    }

    /// Objects with all keys, as many as it takes to show every alternative of every value.
    std::vector<json> objects(const json& schema, bool with_deprecated) const
    {
        std::map<std::string, std::vector<json>> values;
        std::size_t count = left_out(schema, 0).size() + 1;
        for (const auto& [key, value] : schema.at("properties").items()) {
            if (is_deprecated(value) && !with_deprecated) continue;
            values[key] = samples(value, key, with_deprecated);
            count = std::max(count, values[key].size());
        }
        std::vector<json> found;
        if (schema.value("maxProperties", 0) == 1) {
            for (const auto& [key, list] : values)
                for (const json& value : list) found.push_back({{key, value}});
            return found;
        }
        // Each alternative once, and beside others that are not always the same.
        std::minstd_rand random(1);
        for (std::size_t i = 0; i < count; ++i) {
            json object = json::object();
            for (const auto& [key, list] : values)
                object[key] = list[i < list.size() ? i : random() % list.size()];
            for (const std::string& key : left_out(schema, i)) object.erase(key);
            found.push_back(object);
        }
        return found;
    }

    /// Of keys that exclude each other, all but one.
    static std::vector<std::string> left_out(const json& schema, std::size_t turn)
    {
        std::vector<std::string> keys = schema.value("not", json::object()).value("required", json::array());
        if (!keys.empty()) keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(turn % keys.size()));
        return keys;
    }

    json named(const json& schema, bool with_deprecated) const
    {
        json object = json::object();
        for (const json& sample : samples(schema.at("additionalProperties"), "", with_deprecated))
            object["name" + std::to_string(object.size())] = sample;
        return object;
    }

    /// A list for each sample of its items: a reader stops at 1000 faults, so cases are many and small.
    std::vector<json> lists(const json& schema, const std::string& key, bool with_deprecated) const
    {
        std::vector<json> found;
        for (const json& sample : samples(schema.at("items"), key, with_deprecated))
            found.push_back(std::vector<json>(schema.value("minItems", 1U), sample));
        return found;
    }

    static std::vector<json> scalars(const json& schema, const std::string& key)
    {
        static const std::map<std::string, std::string> texts{
            {"record", "record.txt"}, {"records", "record.txt"},  {"unit", "m/s2"},
            {"material", "name0"},    {"default_joint", "name0"}, {"joint", "name0"},
            {"blocks", "everything"}, {"group", "everything"},    {"motion_stage", "shaken"}};
        const json type = schema.value("type", json("string"));
        if (type == "boolean") return {false};
        if (type == "integer" || type == "number")
            return {schema.value("minimum", 1), schema.value("maximum", schema.value("minimum", 1))};
        const auto text = texts.find(key);
        return {text == texts.end() ? key : text->second};
    }

    const json& whole_;
};

}  // namespace

json case_schema()
{
    std::ifstream file(VOUSSOIR_CASES "/../docs/case.schema.json");
    return json::parse(file);
}

SchemaWords words_of(const json& schema)
{
    SchemaWords found;
    Schema(schema).gather(schema, "", found);
    return found;
}

std::vector<json> sample_cases(const json& schema, bool with_deprecated)
{
    const json block = {{"box", {{"name", "stone"}, {"lower", {0, 0, 0}}, {"upper", {1, 1, 1}}}},
                        {"material", "name0"},
                        {"group", "everything"}};
    const json stage = {{"name", "shaken"}, {"type", "dynamic"}};
    std::vector<json> cases = Schema(schema).samples(schema, "", with_deprecated);
    for (json& sample : cases) {
        sample.at("blocks").push_back(block);
        sample.at("stages").push_back(stage);
    }
    return cases;
}

std::string general_path(const std::string& path)
{
    static const std::regex number("\\[[0-9]+\\]"), name("\\bname[0-9]+\\b");
    return std::regex_replace(std::regex_replace(path, number, "[]"), name, "*");
}

}  // namespace voussoir::app::reader
