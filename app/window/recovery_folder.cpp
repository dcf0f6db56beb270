// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/recovery_folder.h"

#include "exchange/mesh_file.h"

#include <QDateTime>
#include <QDir>
#include <QFile>

#include <algorithm>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int mostFolders = 1000; ///< tried before it is said that none can be made

QString copyName(int number) {
    return u"copy-%1.moldwright"_s.arg(number, 6, 10, QChar(u'0'));
}

int numberOf(const QString& copy) {
    return copy.mid(copy.lastIndexOf(u'-') + 1).section(u'.', 0, 0).toInt();
}

} // namespace

RecoveryFolder::~RecoveryFolder() {
    unlock();
}

QString RecoveryFolder::root() {
    const QString state = qEnvironmentVariable("XDG_STATE_HOME", QDir::homePath() + u"/.local/state"_s);
    return state + u"/Moldwright/recovery"_s;
}

bool RecoveryFolder::lock(const QString& path) {
    const QByteArray file = QFile::encodeName(path + u"/lock"_s);
    const int descriptor = ::open(file.constData(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (descriptor < 0)
        return false;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        ::close(descriptor);
        return false;
    }
    m_lock = descriptor;
    m_path = path;
    return true;
}

void RecoveryFolder::unlock() {
    if (m_lock >= 0)
        ::close(std::exchange(m_lock, -1));
}

std::vector<std::shared_ptr<RecoveryFolder>> RecoveryFolder::left() {
    std::vector<std::shared_ptr<RecoveryFolder>> found;
    for (const QFileInfo& entry :
         QDir(root()).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name | QDir::Reversed)) {
        auto folder = std::make_shared<RecoveryFolder>();
        if (!folder->lock(entry.absoluteFilePath()))
            continue; // its program lives
        if (folder->copies().empty())
            folder->clear();
        else
            found.push_back(std::move(folder));
    }
    return found;
}

Result<void> RecoveryFolder::begin() {
    if (const Result<void> made = makeFolder(root().toStdString()); !made)
        return made;
    // Named by the time, so that names tell which is newer; another program may be as quick.
    const QString name = root() + u'/' + QDateTime::currentDateTimeUtc().toString(u"yyyyMMdd-HHmmss-zzz"_s);
    for (int i = 0; i < mostFolders; ++i)
        if (const QString path = u"%1-%2"_s.arg(name).arg(i); QDir().mkdir(path) && lock(path))
            return {};
    return failure(ErrorCode::WriteFailed, MW_TEXT("Project", "No folder can be made in {0}."),
                   {root().toStdString()});
}

Result<void> RecoveryFolder::write(const StoredProject& stored) {
    if (m_lock < 0)
        if (const Result<void> begun = begin(); !begun)
            return begun;
    const std::vector<QString> old = copies();
    const QString file = m_path + u'/' + copyName(old.empty() ? 1 : numberOf(old.front()) + 1);
    if (const Result<void> written = saveProject(file.toStdString(), stored); !written)
        return written;
    for (std::size_t i = copiesKept - 1; i < old.size(); ++i)
        QFile::remove(old[i]);
    return {};
}

std::vector<QString> RecoveryFolder::copies() const {
    std::vector<QString> files;
    if (m_path.isEmpty())
        return files;
    for (const QFileInfo& entry :
         QDir(m_path).entryInfoList({u"copy-*.moldwright"_s}, QDir::Files, QDir::NoSort))
        files.push_back(entry.absoluteFilePath());
    std::ranges::sort(files, std::greater(), &numberOf);
    return files;
}

void RecoveryFolder::clear() {
    if (m_lock < 0)
        return;
    QDir(std::exchange(m_path, QString())).removeRecursively();
    unlock();
}

int RecoveryFolder::failures() const {
    QFile file(m_path + u"/failures"_s);
    return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().toInt() : 0;
}

void RecoveryFolder::setFailures(int count) const {
    QFile file(m_path + u"/failures"_s);
    if (m_lock >= 0 && file.open(QIODevice::WriteOnly))
        file.write(QByteArray::number(count));
}

} // namespace moldwright
