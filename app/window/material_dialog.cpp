// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/material_dialog.h"

#include "theme/theme.h"
#include "window/material_form.h"
#include "window/sentence.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <utility>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int listWidth = 210;
constexpr auto untilKept = std::chrono::milliseconds(400); ///< after the last key

} // namespace

MaterialDialog::MaterialDialog(MaterialPlaces places, QWidget* parent)
    : QDialog(parent), m_places(std::move(places)) {
    setWindowTitle(tr("Materials"));
    setObjectName(u"materials"_s);
    resize(940, 620);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(makeList());
    row->addWidget(makeDetails(), 1);
    column->addLayout(row, 1);
    auto* buttons = new QDialogButtonBox(this);
    QPushButton* close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    close->setObjectName(u"materials-close"_s);
    close->setAutoDefault(false); // Return ends a field, not the dialog
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    m_typing.setSingleShot(true);
    m_typing.setInterval(untilKept);
    connect(&m_typing, &QTimer::timeout, this, &MaterialDialog::keep);
    connect(m_form, &MaterialForm::edited, &m_typing, qOverload<>(&QTimer::start));
    load({});
}

QWidget* MaterialDialog::makeList() {
    auto* side = new QWidget(this);
    side->setFixedWidth(listWidth);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    m_list = new QListWidget(side);
    m_list->setObjectName(u"materials-list"_s);
    m_list->setAccessibleName(tr("Materials"));
    connect(m_list, &QListWidget::currentRowChanged, this, &MaterialDialog::showChosen);
    column->addWidget(m_list, 1);
    auto* line = new QHBoxLayout;
    line->setSpacing(6);
    auto* add = new QPushButton(tr("&New"), side);
    add->setObjectName(u"materials-new"_s);
    add->setAutoDefault(false);
    add->setToolTip(tr("A material of your own, with the values of the one that is chosen."));
    connect(add, &QPushButton::clicked, this, &MaterialDialog::addNew);
    m_remove = new QPushButton(side);
    m_remove->setObjectName(u"materials-remove"_s);
    m_remove->setAutoDefault(false);
    connect(m_remove, &QPushButton::clicked, this, &MaterialDialog::removeChosen);
    line->addWidget(add, 1);
    line->addWidget(m_remove, 1);
    column->addLayout(line);
    return side;
}

QWidget* MaterialDialog::makeDetails() {
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    m_form = new MaterialForm(side);
    auto* scroll = new QScrollArea(side);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(m_form);
    column->addWidget(scroll, 1);
    m_told = new QLabel(side);
    m_told->setObjectName(u"materials-told"_s);
    m_told->setWordWrap(true);
    column->addWidget(m_told);
    return side;
}

bool MaterialDialog::isOwn(const std::string& id) const {
    return std::ranges::find(m_own, id, &Material::id) != m_own.end();
}

void MaterialDialog::tell(const QString& words, bool failing) {
    QPalette palette = m_told->palette();
    palette.setColor(QPalette::WindowText, failing ? toColor(theme().scene.errorInk)
                                                   : QWidget::palette().color(QPalette::WindowText));
    m_told->setPalette(palette);
    m_told->setText(words);
}

void MaterialDialog::tellStanding() {
    tell(isOwn(m_chosen.id)
             ? tr("Yours. A project keeps the values it was given; choose the material there anew "
                  "to have these.")
             : tr("Comes with the program. What you change is kept as your own."),
         false);
}

void MaterialDialog::load(const std::string& chosen) {
    Result<std::vector<Material>> own = ownMaterials(m_places);
    Result<std::vector<Material>> table = materialTable(m_places);
    const QString trouble = own && table ? QString() : sentence((own ? table.error() : own.error()).message);
    if (!table)
        table = materialTable({m_places.bundled, std::nullopt});
    m_own = std::move(own).value_or(std::vector<Material>());
    m_table = std::move(table).value_or(std::vector<Material>());
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    int row = 0;
    for (const Material& material : m_table) {
        auto* item = new QListWidgetItem(sentence(material.name), m_list);
        QFont font = item->font();
        font.setBold(isOwn(material.id));
        item->setFont(font);
        if (material.id == chosen)
            row = m_list->count() - 1;
    }
    m_list->setCurrentRow(row);
    showChosen();
    if (!trouble.isEmpty())
        tell(trouble, true);
}

void MaterialDialog::showChosen() {
    if (m_typing.isActive())
        keep();
    const int row = m_list->currentRow();
    if (row < 0 || row >= static_cast<int>(m_table.size()))
        return;
    m_chosen = m_table[static_cast<std::size_t>(row)];
    m_form->setMaterial(m_chosen);
    const Result<std::vector<Material>> bundled = materialTable({m_places.bundled, std::nullopt});
    const bool replaces =
        bundled && std::ranges::find(*bundled, m_chosen.id, &Material::id) != bundled->end();
    m_remove->setText(replaces ? tr("As &before") : tr("&Remove"));
    m_remove->setToolTip(replaces ? tr("Take the values again that come with the program.")
                                  : tr("Forget this material of yours."));
    m_remove->setEnabled(isOwn(m_chosen.id));
    tellStanding();
}

void MaterialDialog::keep() {
    m_typing.stop();
    const Material typed = m_form->material();
    if (typed == m_chosen)
        return tellStanding();
    if (const Result<void> saved = saveMaterial(m_places, typed); !saved)
        return tell(sentence(saved.error().message), true);
    m_chosen = typed;
    Result<std::vector<Material>> own = ownMaterials(m_places);
    m_own = std::move(own).value_or(m_own);
    const auto kept = std::ranges::find(m_table, typed.id, &Material::id);
    if (kept != m_table.end()) {
        *kept = typed;
        QListWidgetItem* item = m_list->item(static_cast<int>(kept - m_table.begin()));
        item->setText(sentence(typed.name));
        QFont font = item->font();
        font.setBold(true);
        item->setFont(font);
    }
    m_remove->setEnabled(true);
    tellStanding();
    Q_EMIT tableChanged();
}

void MaterialDialog::addNew() {
    keep();
    Material fresh = m_chosen;
    fresh.name = tr("%1, own").arg(sentence(m_chosen.name)).toStdString();
    fresh.id = freeMaterialId(m_chosen.id + " own", m_table);
    if (const Result<void> saved = saveMaterial(m_places, fresh); !saved)
        return tell(sentence(saved.error().message), true);
    load(fresh.id);
    Q_EMIT tableChanged();
}

void MaterialDialog::removeChosen() {
    m_typing.stop();
    const std::string id = m_chosen.id;
    if (const Result<void> removed = removeMaterial(m_places, id); !removed)
        return tell(sentence(removed.error().message), true);
    load(id);
    Q_EMIT tableChanged();
}

void MaterialDialog::done(int result) {
    if (m_typing.isActive())
        keep();
    QDialog::done(result);
}

} // namespace moldwright
