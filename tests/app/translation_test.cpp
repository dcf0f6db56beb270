// SPDX-License-Identifier: AGPL-3.0-or-later
// Every sentence a person can meet is translated, wherever it comes from.
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

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

using namespace moldwright;
using namespace Qt::StringLiterals;

namespace {

std::string textOf(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

std::set<std::string> contextsOfTheCore() {
    std::set<std::string> contexts;
    const std::regex marked(R"re(MW_TEXT\(\s*"([^"]+)")re");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sourceFolder() / "core")) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h")
            continue;
        const std::string text = textOf(entry.path());
        for (std::sregex_iterator it(text.begin(), text.end(), marked), end; it != end; ++it)
            contexts.insert((*it)[1]);
    }
    return contexts;
}

class German : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(m_translator.load(u":/i18n/moldwright_de.qm"_s)); }

    [[nodiscard]] bool knows(const char* context, const QByteArray& text) const {
        return !m_translator.translate(context, text.constData()).isEmpty();
    }

private:
    QTranslator m_translator;
};

} // namespace

TEST(Translation, TheWindowKnowsEveryContextOfTheCoresSentences) {
    const std::set<std::string> contexts = contextsOfTheCore();
    EXPECT_GE(contexts.size(), 5U) << "the sources were not found";
    for (const std::string& context : contexts)
        EXPECT_TRUE(sentenceContexts().contains(QString::fromStdString(context))) << context;
}

TEST(Translation, NothingIsLeftUnfinished) {
    QFile file(QString::fromStdString((test::sourceFolder() / "translations/moldwright_de.ts").string()));
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
            EXPECT_FALSE(xml.readElementText().isEmpty()) << source.toStdString();
        }
    }
    EXPECT_FALSE(xml.hasError());
    EXPECT_GT(messages, 400);
}

TEST_F(German, EveryCommandHasItsWords) {
    for (const ActionSpec& spec : actionTable())
        for (const char* text : {spec.menu, spec.text, spec.hint})
            EXPECT_TRUE(knows("Actions", text)) << text;
}

TEST_F(German, EverySampleHasItsWords) {
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
