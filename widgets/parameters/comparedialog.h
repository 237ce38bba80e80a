// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/panel.h"
#include "widgets/parameters/comparison.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace trex {

/// Two configurations beside each other: of the controller, of files, the factory's. Not modal,
/// with a STOP of its own; follows what is read from the controller. GUI thread.
class CompareDialog : public QDialog {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(CompareDialog)

public:
    explicit CompareDialog(PanelContext& context, QWidget* parent = nullptr);

private:
    struct Side {
        QComboBox* source = nullptr;
        QPushButton* open = nullptr;
        std::optional<Configuration> file;
    };
    void buildSide(Side& side, const QString& part, const QString& title);
    void openFile(Side& side);
    void loadFile(Side& side, const QString& path);
    void refresh();
    [[nodiscard]] Configuration configuration(const Side& side) const;
    void copy() const;

    PanelContext& m_context;
    Side m_left;
    Side m_right;
    QTreeWidget* m_table;
    QLabel* m_summary;
    std::vector<ComparedSetting> m_settings; ///< shown
};

} // namespace trex
