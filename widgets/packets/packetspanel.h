// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/panel.h"
#include "widgets/packets/packetmodel.h"

#include <QTimer>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QTableView;
class QToolButton;

namespace trex {

/// Every transaction with its time, bytes, meaning and errors; filter, pause; and a packet of one's
/// own. GUI thread.
class PacketsPanel : public Panel {
    Q_OBJECT

public:
    explicit PacketsPanel(PanelContext& context, QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void buildBar(QHBoxLayout& bar);
    void buildView();
    void setColumnWidths();
    void applyFilter();
    void onStateChanged();
    void refresh(); ///< once a tick while visible
    void showCounts();
    [[nodiscard]] bool isAtEnd() const;

    PacketModel m_model;
    QTimer m_filterDelay; ///< the whole ring is searched once the typing rests
    QTableView* m_view = nullptr;
    QLineEdit* m_filter = nullptr;
    QComboBox* m_class = nullptr;
    QToolButton* m_pause = nullptr;
    QLabel* m_counts = nullptr;
    QMetaObject::Connection m_ticking;
};

} // namespace trex
