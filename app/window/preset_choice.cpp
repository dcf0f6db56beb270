// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/preset_choice.h"

#include "exchange/user_folder.h"
#include "project/presets.h"
#include "window/action_table.h"
#include "window/document.h"
#include "window/sentence.h"
#include "window/workbench.h"

#include <QCoreApplication>
#include <QInputDialog>

#include <filesystem>
#include <functional>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Presets)
};

std::filesystem::path folder() {
    return userFolder("presets").value_or(std::filesystem::path());
}

/// Saves the settings under a name that is asked for; `done` hears how that went.
void askForName(const MoldSettings& settings, QWidget* window,
                const std::function<void(const Result<void>&)>& done) {
    auto* dialog = new QInputDialog(window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(u"preset-name"_s);
    dialog->setWindowTitle(Words::tr("Save as a preset"));
    dialog->setLabelText(Words::tr("Name; one that is there already is replaced:"));
    QObject::connect(dialog, &QInputDialog::textValueSelected, window, [settings, done](const QString& name) {
        done(savePreset(folder(), name.trimmed().toStdString(), settings));
    });
    dialog->open();
}

Result<void> removeShown(const MoldSettings& settings) {
    const int shown = presetShown(settings);
    if (shown == 0)
        return failure(
            ErrorCode::Usage,
            MW_TEXT("Presets", "The settings are none of the presets. Take one over to remove it."));
    return removePreset(folder(), presetNames(folder())[static_cast<std::size_t>(shown - 1)]);
}

} // namespace

PropertySection presetSection(const Actions& actions) {
    return {Words::tr("Preset"),
            {{presetRow(), Words::tr("Take over"),
              Words::tr("Block, layout, features and machines as they were saved under a name. Shrink and "
                        "density stay as they are."),
              ChoiceProperty{QStringList(Words::tr("As set here")) + presetNamesShown()}}},
            {actions[u"save-preset"_s], actions[u"remove-preset"_s]},
            false};
}

QString presetRow() {
    return u"preset"_s;
}

QStringList presetNamesShown() {
    QStringList names;
    for (const std::string& name : presetNames(folder()))
        names += QString::fromStdString(name);
    return names;
}

int presetShown(const MoldSettings& settings) {
    const std::vector<std::string> names = presetNames(folder());
    for (std::size_t i = 0; i < names.size(); ++i)
        if (presetHolds(settings, folder(), names[i]))
            return static_cast<int>(i) + 1;
    return 0;
}

MoldSettings withPresetShown(const MoldSettings& settings, int choice) {
    const std::vector<std::string> names = presetNames(folder());
    if (choice < 1 || choice > static_cast<int>(names.size()))
        return settings;
    return withPreset(settings, folder(), names[static_cast<std::size_t>(choice - 1)]).value_or(settings);
}

void connectPresets(Actions& actions, Workbench& bench, QWidget* window) {
    const auto tell = [&bench](const Result<void>& done) {
        if (!done)
            bench.say(Standing::Failing, sentence(done.error().message));
        Q_EMIT bench.changed();
    };
    const auto settings = [&bench] { return bench.document().committed().mold; };
    actions.on(u"save-preset"_s, [=] { askForName(settings(), window, tell); });
    actions.on(u"remove-preset"_s, [=] { tell(removeShown(settings())); });
}

} // namespace moldwright
