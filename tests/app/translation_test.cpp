// SPDX-License-Identifier: AGPL-3.0-or-later
// Every sentence a person can meet is translated, wherever it comes from.
#include "language/core_words.h"
#include "materials/material_table.h"
#include "support/folders.h"
#include "window/action_table.h"
#include "window/sentence.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTranslator>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <tuple>
#include <vector>

using namespace moldwright;
using namespace Qt::StringLiterals;

namespace {

std::string textOf(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// A text marked by MW_TEXT.
struct Sentence {
    std::string context;
    std::string text;
    bool operator<(const Sentence& other) const {
        return std::tie(context, text) < std::tie(other.context, other.text);
    }
};

/// The texts of string literals that stand one after the other.
std::string joined(const std::string& literals) {
    static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
    std::string text;
    for (std::sregex_iterator it(literals.begin(), literals.end(), literal), end; it != end; ++it)
        text += (*it)[1];
    text = std::regex_replace(text, std::regex(R"(\\n)"), "\n");
    return std::regex_replace(text, std::regex(R"(\\(["\\]))"), "$1");
}

std::set<Sentence> sentencesOfTheCore() {
    std::set<Sentence> sentences;
    const std::regex marked(R"re(MW_TEXT\(\s*"([^"]+)",\s*((?:"(?:[^"\\]|\\.)*"\s*)+)\))re");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sourceFolder() / "core")) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h")
            continue;
        const std::string text = textOf(entry.path());
        for (std::sregex_iterator it(text.begin(), text.end(), marked), end; it != end; ++it)
            sentences.insert({(*it)[1], joined((*it)[2])});
    }
    return sentences;
}

/// The places for values in a text, sorted: %1 and {0}.
std::vector<std::string> placesIn(const QString& text) {
    static const std::regex place(R"(%\d|\{\d\})");
    const std::string utf8 = text.toStdString();
    std::vector<std::string> places;
    for (std::sregex_iterator it(utf8.begin(), utf8.end(), place), end; it != end; ++it)
        places.push_back(it->str());
    std::ranges::sort(places);
    return places;
}

/// Each translation, by the name of its file.
class Translated : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        ASSERT_TRUE(m_translator.load(u":/i18n/%1.qm"_s.arg(QLatin1String(GetParam()))));
    }

    [[nodiscard]] bool knows(const char* context, const QByteArray& text) const {
        return !m_translator.translate(context, text.constData()).isEmpty();
    }

private:
    QTranslator m_translator;
};

} // namespace

TEST(Translation, TheWindowKnowsEveryContextOfTheCoresSentences) {
    for (const Sentence& sentence : sentencesOfTheCore())
        EXPECT_TRUE(sentenceContexts().contains(QString::fromStdString(sentence.context)))
            << sentence.context;
}

INSTANTIATE_TEST_SUITE_P(Languages, Translated, testing::Values("moldwright_de", "moldwright_zh_CN"));

TEST_P(Translated, NothingIsLeftUnfinishedAndNoPlaceIsLost) {
    const std::filesystem::path folder = test::sourceFolder() / "translations";
    QFile file(QString::fromStdString((folder / (std::string(GetParam()) + ".ts")).string()));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString source;
    int messages = 0;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == "source"_L1) {
            source = xml.readElementText();
        } else if (xml.name() == "translation"_L1) {
            ++messages;
            EXPECT_NE(xml.attributes().value("type"_L1), "unfinished"_L1) << source.toStdString();
            const QString text = xml.readElementText();
            EXPECT_FALSE(text.isEmpty()) << source.toStdString();
            EXPECT_EQ(placesIn(text), placesIn(source)) << source.toStdString();
        }
    }
    EXPECT_FALSE(xml.hasError());
    EXPECT_GT(messages, 400);
}

TEST_P(Translated, EverySentenceOfTheCoreHasItsWords) {
    const std::set<Sentence> sentences = sentencesOfTheCore();
    EXPECT_GT(sentences.size(), 300U) << "the sources were not found";
    for (const Sentence& sentence : sentences)
        EXPECT_TRUE(knows(sentence.context.c_str(), QByteArray::fromStdString(sentence.text)))
            << sentence.context << ": " << sentence.text;
}

TEST_P(Translated, EveryCommandHasItsWords) {
    for (const ActionSpec& spec : actionTable())
        for (const char* text : {spec.menu, spec.text, spec.hint})
            EXPECT_TRUE(knows("Actions", text)) << text;
}

TEST_P(Translated, EveryMaterialHasItsWords) {
    const std::filesystem::path file = test::sourceFolder() / "resources/materials/materials.json";
    const std::vector<Material> table = *materialTable({file, std::nullopt});
    ASSERT_FALSE(table.empty());
    for (const Material& m : table) {
        std::vector<std::string> texts = {m.name, m.process, m.notes};
        const Preparation& p = m.preparation;
        texts.insert(texts.end(), {p.sealing, p.release, p.filling, p.setting, p.source});
        for (const MaterialValue& value :
             {m.shrinkPercent, m.draftDegrees, m.density, m.ventDepth.value_or(m.density)})
            texts.insert(texts.end(), {value.range, value.source, value.status});
        for (const std::string& text : texts)
            EXPECT_TRUE(text.empty() || knows("Materials", QByteArray::fromStdString(text))) << text;
    }
}

TEST_P(Translated, EverySampleHasItsWords) {
    QFile list(QString::fromStdString((test::samples() / "samples.json").string()));
    ASSERT_TRUE(list.open(QIODevice::ReadOnly));
    const QJsonArray samples = QJsonDocument::fromJson(list.readAll()).object().value("samples"_L1).toArray();
    ASSERT_FALSE(samples.isEmpty());
    for (const QJsonValue& sample : samples)
        for (const QString& key : {u"title"_s, u"description"_s}) {
            const QByteArray text = sample[key].toString().toUtf8();
            EXPECT_TRUE(knows("Samples", text)) << text.constData();
        }
}

TEST(Translation, NegativeCoordinatesHaveAMinusAndFileNamesKeepTheirHyphens) {
    EXPECT_EQ(sentence(Message{"near ({0}, {1}) of {2}", {"-1.5", "-2", "part (-1),-5.stl"}}),
              QString::fromUtf8("near (−1.5, −2) of part (-1),-5.stl"));
}
