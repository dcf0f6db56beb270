// SPDX-License-Identifier: AGPL-3.0-or-later
// Random walks through the window's commands: wherever undo and redo come back to, the document is the same.
#include "app/document_hash.h"
#include "app/window_driver.h"

#include "view/part_view.h"
#include "window/document.h"
#include "window/main_window.h"
#include "window/property_pages.h"

#include <QTest>

#include <gtest/gtest.h>

#include <functional>
#include <random>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::hashOf;
using test::WindowDriver;

namespace {

/// Walks, and remembers the document after every number of steps done.
class Walk {
public:
    Walk(WindowDriver& driver, unsigned seed) : m_driver(driver), m_random(seed) {
        const History& history = document().history();
        for (std::size_t i = 0; i < history.done(); ++i)
            m_hashes.push_back(hashOf(history.steps()[i].before));
        m_hashes.push_back(hashOf(document().committed()));
    }

    void step() {
        static const std::vector<const char*> edits = {
            "turn-x",  "turn-y",  "turn-z",      "centre",     "normal-directions", "plane-x",
            "plane-y", "plane-z", "accept-tips", "clear-pins", "duplicate-variant", "next-variant"};
        const unsigned choice = m_random() % 21;
        const std::size_t before = document().history().done();
        if (choice < edits.size())
            trigger(edits[choice]);
        else if (choice == 12)
            type(u"deform"_s, u"draft"_s, 0.5 + static_cast<double>(m_random() % 30) / 10);
        else if (choice == 13)
            type(u"mold"_s, u"wall"_s, 1 + static_cast<double>(m_random() % 20));
        else if (choice == 14)
            type(u"plane"_s, u"offset"_s, static_cast<double>(m_random() % 40) - 20);
        else if (choice == 15)
            removeVariant();
        else
            return trigger(choice < 19 ? "undo" : "redo");
        const std::size_t done = document().history().done();
        const std::size_t hash = hashOf(document().committed());
        if (done > before) {
            m_hashes.resize(before + 1);
            m_hashes.push_back(hash);
        } else if (done == before && hash != m_hashes[done]) {
            m_hashes.resize(done + 1); // it became one with the step before
            m_hashes[done] = hash;
        }
    }

    void check(int step) const {
        const std::size_t done = m_driver.bench().document().history().done();
        ASSERT_LT(done, m_hashes.size()) << "step " << step;
        ASSERT_EQ(hashOf(m_driver.bench().document().committed()), m_hashes[done]) << "step " << step;
    }

    [[nodiscard]] std::size_t first() const { return m_hashes.front(); }

private:
    Document& document() { return m_driver.bench().document(); }

    void trigger(const char* command) {
        m_driver.window().actions()[QString::fromLatin1(command)]->trigger();
    }

    /// The current one, where no run goes on.
    void removeVariant() {
        if (!m_driver.bench().background().busy())
            m_driver.bench().removeVariant(static_cast<int>(document().committed().place));
    }

    void type(const QString& page, const QString& id, double value) {
        applyProperty(m_driver.bench(), page, id, value, false);
    }

    WindowDriver& m_driver;
    std::mt19937 m_random;
    std::vector<std::size_t> m_hashes; ///< after so many steps done
};

} // namespace

TEST(Walk, AThousandEditsUndosAndRedosComeBackToEqualDocuments) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+G");
    ASSERT_TRUE(driver.waitIdle());
    Walk walk(driver, 7);
    for (int step = 0; step < 1000; ++step) {
        walk.step();
        ASSERT_NO_FATAL_FAILURE(walk.check(step));
        if (step % 20 == 0)
            QTest::qWait(1); // the window follows, and enables what may be done
    }
    while (driver.bench().document().history().canUndo())
        driver.bench().document().undo();
    EXPECT_EQ(hashOf(driver.bench().document().committed()), walk.first());
}

TEST(Walk, EditsWhileASolveRunsComeBackTooAndItsResultIsOneStep) {
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("bent_beam"));
    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    Document& document = driver.bench().document();
    Walk walk(driver, 11);
    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().frame().has_value(); }, 180000));
    int steps = 0;
    for (; steps < 1000 && driver.bench().running(); ++steps) {
        walk.step();
        ASSERT_NO_FATAL_FAILURE(walk.check(steps));
        if (steps % 10 == 0)
            QTest::qWait(1);
    }
    EXPECT_GT(steps, 50) << "it ran while edits were made";
    const std::size_t hash = hashOf(document.committed());
    const std::size_t done = document.history().done();
    if (driver.bench().running()) {
        ASSERT_TRUE(driver.waitIdle(300000));
        EXPECT_EQ(document.history().done(), done + 1);
        driver.press("Ctrl+Z");
        EXPECT_EQ(hashOf(document.committed()), hash);
    }
    while (document.history().canUndo())
        document.undo();
    EXPECT_EQ(hashOf(document.committed()), walk.first());
}
