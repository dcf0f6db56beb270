// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "theme/icons.h"

#include <QAbstractListModel>
#include <QListView>
#include <QTime>

#include <Eigen/Geometry>

#include <vector>

namespace moldwright {

/// One message of the session.
struct SessionMessage {
    Standing standing = Standing::Info;
    QTime time;
    QString text;
    Eigen::AlignedBox3d place; ///< what Show me frames; empty: nothing to show
};

/// The session's messages, newest first.
class MessageModel : public QAbstractListModel {
    Q_OBJECT
public:
    using QAbstractListModel::QAbstractListModel;
    void add(const SessionMessage& message);
    void clear();
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] const SessionMessage& at(int row) const { return m_messages[row]; }

private:
    std::vector<SessionMessage> m_messages;
};

/// The list of messages; a message with a place has Show me (click, or Enter).
class MessageList : public QListView {
    Q_OBJECT
public:
    MessageList(MessageModel* model, QWidget* parent = nullptr);

Q_SIGNALS:
    void showMe(const Eigen::AlignedBox3d& place);

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace moldwright
