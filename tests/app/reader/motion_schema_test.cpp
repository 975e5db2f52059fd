// The schema for editors and the reader know the same keys of motions.
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/app/reader/motion_case.h"

namespace voussoir::app::reader
{
namespace
{

/// Far from every key, so that the reader answers with all it knows.
const std::string unknown = "qqqqqqqqqqqq";

nlohmann::json schema()
{
    std::ifstream file(VOUSSOIR_CASES "/../docs/case.schema.json");
    return nlohmann::json::parse(file);
}

/// The words after "known here: " in the fault about the unknown key.
std::set<std::string> keys_in(const std::string& faults)
{
    const std::size_t key = faults.find(unknown + ": unknown key; known here: ");
    if (key == std::string::npos) throw std::logic_error("no list of keys in " + faults);
    const std::size_t begin = faults.find("here: ", key) + 6;
    std::istringstream words(faults.substr(begin, faults.find('\n', begin) - begin));
    std::set<std::string> keys;
    for (std::string word; std::getline(words >> std::ws, word, ',');) keys.insert(word);
    return keys;
}

struct Place {
    std::string in_schema;                 // JSON pointer to an object's schema, from $defs
    std::string motion;                    // with KEY for an unknown one
    std::set<std::string> elsewhere = {};  // keys of the other form, which the reader knows here too
};

void PrintTo(const Place& place, std::ostream* out)
{
    *out << place.in_schema;
}

class MotionSchema : public MotionCase, public testing::WithParamInterface<Place>
{
};

TEST_P(MotionSchema, HasTheKeysOfTheReader)
{
    std::set<std::string> keys = GetParam().elsewhere;
    const nlohmann::json object = schema().at(nlohmann::json::json_pointer("/$defs/" + GetParam().in_schema));
    for (const auto& [key, value] : object.at("properties").items()) keys.insert(key);
    EXPECT_EQ(keys, keys_in(faults_of(moved_by(with(GetParam().motion, "KEY", unknown + ": 1")))));
}

Place step(const std::string& in_schema, const std::string& text, const std::set<std::string>& elsewhere = {})
{
    return {"processing/items/oneOf/1" + in_schema,
            "{x: {ricker: {acceleration: 1 g, frequency: 1 Hz}, processing: [" + text + "]}}", elsewhere};
}

const std::string eurocode = "{match: {target: {eurocode_8: {acceleration: 1 g, KEY}}}}";

INSTANTIATE_TEST_SUITE_P(
    All, MotionSchema,
    testing::Values(Place{"motion/oneOf/1/properties/sine", "{x: {sine: {KEY}}}"},
                    Place{"motion/oneOf/2/properties/ramped_sine", "{x: {ramped_sine: {KEY}}}"},
                    Place{"motion/oneOf/3/properties/sweep", "{x: {sweep: {KEY}}}"},
                    Place{"motion/oneOf/4/properties/ricker", "{x: {ricker: {KEY}}}"},
                    Place{"motion/oneOf/5/properties/pulse", "{x: {pulse: {KEY}}}"},
                    Place{"motion/oneOf/6/properties/noise", "{x: {noise: {KEY}}}"},
                    Place{"motions/oneOf/1", "{records: [], axes: [], KEY}"}, step("", "{KEY}"),
                    step("/properties/window/oneOf/0", "{window: {KEY}}", {"arias"}),
                    step("/properties/window/oneOf/1", "{window: {arias: [1 %, 9 %], KEY}}"),
                    step("/properties/band_pass", "{band_pass: {KEY}}"),
                    step("/properties/high_pass", "{high_pass: {KEY}}"),
                    step("/properties/low_pass", "{low_pass: {KEY}}"),
                    step("/properties/scale_to_pga/anyOf/1", "{scale_to_pga: {KEY}}"),
                    step("/properties/scale_to_spectrum", "{scale_to_spectrum: {KEY}}"),
                    step("/properties/rotate", "{rotate: {KEY}}"), step("/properties/match", "{match: {KEY}}"),
                    Place{"target_spectrum/oneOf/0/properties/eurocode_8", step("", eurocode).motion},
                    Place{"target_spectrum/oneOf/1",
                          step("", "{match: {target: {table: [], eurocode_8: {}, KEY}}}").motion,
                          {"eurocode_8"}}));

/// The keys of all motions are more than a fault lists; but none of the schema's may be unknown.
TEST_F(MotionCase, KeysOfTheSchemaAreKnown)
{
    const nlohmann::json motions = schema().at("/$defs/motion/oneOf"_json_pointer);
    for (const auto& object : motions) {
        const std::string source = object.at("required").at(0);
        std::string text = "{x: {" + source + ": 1";
        for (const auto& [key, value] : object.at("properties").items())
            if (key != source) text += ", " + key + ": 1";
        EXPECT_EQ(faults_of(moved_by(text + "}}")).find("unknown key"), std::string::npos) << text;
    }
    EXPECT_EQ(motions.size(), 7);
}

}  // namespace
}  // namespace voussoir::app::reader
