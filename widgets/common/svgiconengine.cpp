// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/svgiconengine.h"

#include <QFile>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

/// The colour that the icon files are drawn in (the text role of the light theme).
constexpr QLatin1StringView kDrawnColour = "#1F2328"_L1;

} // namespace

SvgIconEngine::SvgIconEngine(QString file, ColourRole role) : m_file(std::move(file)), m_role(role)
{
}

void SvgIconEngine::paint(QPainter* painter, const QRect& rect, QIcon::Mode mode,
                          QIcon::State state)
{
    const double ratio =
        painter->device() != nullptr ? painter->device()->devicePixelRatioF() : 1.0;
    const QPixmap picture = pixmap(rect.size() * ratio, mode, state);
    painter->drawPixmap(rect, picture);
}

QPixmap SvgIconEngine::pixmap(const QSize& size, QIcon::Mode mode, QIcon::State /*state*/)
{
    QColor colour = theme::colour(mode == QIcon::Disabled ? ColourRole::Stale : m_role);
    if (mode == QIcon::Selected) {
        colour = theme::colour(ColourRole::Panel);
    }
    const QString cacheKey =
        u"%1|%2|%3x%4"_s.arg(m_file, colour.name()).arg(size.width()).arg(size.height());
    QPixmap picture;
    if (QPixmapCache::find(cacheKey, &picture)) {
        return picture;
    }
    picture = QPixmap(size);
    picture.fill(Qt::transparent);
    QFile file(m_file);
    if (file.open(QIODevice::ReadOnly)) {
        QString source = QString::fromUtf8(file.readAll());
        source.replace(kDrawnColour, colour.name(), Qt::CaseInsensitive);
        QSvgRenderer renderer(source.toUtf8());
        renderer.setAspectRatioMode(Qt::KeepAspectRatio);
        QPainter painter(&picture);
        renderer.render(&painter, QRectF(QPointF(0, 0), QSizeF(size)));
    }
    QPixmapCache::insert(cacheKey, picture);
    return picture;
}

QIconEngine* SvgIconEngine::clone() const
{
    return new SvgIconEngine(m_file, m_role); // the QIcon that asked owns it
}

QString SvgIconEngine::key() const
{
    return u"trex-svg"_s;
}

} // namespace trex
