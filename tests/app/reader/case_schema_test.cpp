// The schema for editors and the reader of cases know the same keys and the same words, object by object.
#include <gtest/gtest.h>

#include "app/reader/asked_keys.h"
#include "app/reader/processing.h"
#include "tests/app/reader/case_reading.h"
#include "tests/app/reader/schema_samples.h"

namespace voussoir::app::reader
{
namespace
{

using Words = std::map<std::string, std::set<std::string>>;

std::string listed(const std::set<std::string>& words)
{
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
}

/// Reads all samples of the schema.
class CaseSchema : public testing::Test
{
 protected:
    CaseSchema()
    {
        asked_keys = &asked_;
        folder_.write("record.txt", "0 0\n0.01 1\n0.02 -1\n0.03 0\n");
    }
    ~CaseSchema() override { asked_keys = nullptr; }

    void read_samples(bool with_deprecated)
    {
        for (const nlohmann::json& sample : sample_cases(schema_, with_deprecated))
            for (const char* kinematics : {"kinematics=spatial_deformable", "kinematics=planar_deformable"}) {
                try {
                    read_case(folder_.write("case.yaml", sample.dump(1)), {kinematics});
                } catch (const InputError& error) {
                    faults_.insert(faults_.end(), error.faults.begin(), error.faults.end());
                }
            }
    }
    /// The paths of faults that say `part`.
    std::set<std::string> faulty(const std::string& part) const
    {
        std::set<std::string> paths;
        for (const Fault& fault : faults_)
            if (fault.found.find(part) != std::string::npos)
                paths.insert(general_path(fault.place.substr(fault.place.rfind(' ') + 1)));
        return paths;
    }
    static Words general(const Words& by_path)
    {
        Words all;
        for (const auto& [path, words] : by_path) all[general_path(path)].insert(words.begin(), words.end());
        return all;
    }

    const nlohmann::json schema_ = case_schema();
    const SchemaWords known_ = words_of(schema_);
    const TemporaryFolder folder_;
    AskedKeys asked_;
    std::vector<Fault> faults_;
};

TEST_F(CaseSchema, HasTheKeysThatTheReaderAsksFor)
{
    read_samples(false);
    EXPECT_TRUE(faulty("so many faults").empty());
    const Words asked = general(asked_.keys);
    for (const auto& [path, keys] : known_.keys) {
        const auto heard = asked.find(path);
        if (heard == asked.end()) {
            ADD_FAILURE() << "no reader asks for the keys of \"" << path << "\": " << listed(keys);
            continue;
        }
        std::set<std::string> current = heard->second;
        if (known_.deprecated.count(path) > 0)
            for (const std::string& old : known_.deprecated.at(path)) current.erase(old);
        EXPECT_EQ(listed(keys), listed(current)) << "at \"" << path << "\" the schema, then the reader";
    }
    for (const auto& [path, keys] : asked)
        EXPECT_EQ(known_.keys.count(path), 1) << "not in the schema: \"" << path << "\" with " << listed(keys);
    EXPECT_GT(known_.keys.size(), 40);
}

TEST_F(CaseSchema, HasNoKeyThatTheReaderRefusesAsUnknown)
{
    read_samples(true);
    std::set<std::string> unknown = faulty("unknown key");
    unknown.erase("blocks[].wall.header_every");  // asked for if there are several leaves
    EXPECT_EQ(listed(unknown), "");
    EXPECT_FALSE(faults_.empty()) << "the samples make no sense";
}

/// Where the words are no choice of YamlCursor, the tests below, those of joint records, of joints and of bars
/// in case files hold them.
const std::set<std::string> read_by_hand{"processing[]", "integrate",   "differentiate", "type",    "azimuths[]",
                                         "axes[]",       "restitution", "side",          "sides[]", "motion_is",
                                         "carries",      "carries[]",   "time_step"};

std::string end_of(const std::string& path)
{
    return path.substr(path.rfind('.') + 1);
}

TEST_F(CaseSchema, HasTheWordsThatTheReaderTakes)
{
    read_samples(false);
    const Words heard = general(asked_.words);
    for (const auto& [path, words] : known_.words) {
        const auto at = heard.find(path);
        if (at != heard.end())
            EXPECT_EQ(listed(words), listed(at->second)) << "at \"" << path << "\" the schema, then the reader";
        else
            EXPECT_EQ(read_by_hand.count(end_of(path)), 1) << path << " is no choice of the reader";
    }
    for (const auto& [path, words] : heard)
        EXPECT_EQ(known_.words.count(path), 1) << "no words in the schema: \"" << path << "\", " << listed(words);
    EXPECT_GT(heard.size(), 20);
}

bool are_steps(const std::pair<std::string, std::string>& around, const std::string& word)
{
    try {
        parse_processing_steps(around.first + word + around.second, "steps");
        return true;
    } catch (const InputError&) {
        return false;
    }
}

TEST_F(CaseSchema, HasTheWordsOfProcessing)
{
    const std::set<std::string> vocabulary{
        "mean", "end_correction", "velocity", "displacement", "acceleration", "taper", "0", "1", "2", "3"};
    const std::map<std::string, std::pair<std::string, std::string>> around{
        {"processing[]", {"[", "]"}},
        {"integrate", {"[{integrate: ", "}]"}},
        {"differentiate", {"[{differentiate: ", "}]"}},
        {"eurocode_8.type", {"[{match: {target: {eurocode_8: {acceleration: 1 m/s2, type: ", "}}}}]"}}};
    std::size_t probed = 0;
    for (const auto& [path, words] : known_.words)
        for (const auto& [end, text] : around) {
            if (path.size() < end.size() || path.substr(path.size() - end.size()) != end) continue;
            ++probed;
            for (const std::string& word : vocabulary)
                EXPECT_EQ(words.count(word) == 1, are_steps(text, word)) << path << ": " << word;
        }
    EXPECT_GE(probed, around.size());
}

}  // namespace
}  // namespace voussoir::app::reader
