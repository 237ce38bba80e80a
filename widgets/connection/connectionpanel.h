// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/linechange.h"
#include "protocol/procedures/scan.h"
#include "widgets/common/panel.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace trex {

class LineForm;
class LinkStateLabel;
class PortBox;

/// Which port, how the line is set, connect and disconnect, the search for unknown line settings
/// (Scan fills them in, Recover connects with them), a change of the controller's own line
/// settings, and what is wrong and what to try when it fails. GUI thread.
class ConnectionPanel : public Panel {
    Q_OBJECT

public:
    explicit ConnectionPanel(PanelContext& context, QWidget* parent = nullptr);

private:
    void buildFields(QVBoxLayout& layout);
    void buildButtons(QVBoxLayout& layout);
    QPushButton* addButton(const QString& icon, const QString& text, const QString& name);
    void setInitialValues();
    void fillFrom(const QString& port); ///< with the settings that last worked there, if any
    void openLine();
    void toggleScan();
    void toggleRecover();
    void startScan();
    void adopt(const ScanHit& hit);
    [[nodiscard]] QString failureText(const Result<void>& result, const Scan& scan) const;
    void onScanFinished(const Result<void>& result);
    void onStateChanged();
    void refresh();
    void showScan(int done, int total, const QString& text);
    [[nodiscard]] bool checkPort(); ///< says what is wrong with the address
    [[nodiscard]] bool isScanning() const { return m_scan != nullptr; }
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] QString adviceText() const;
    [[nodiscard]] QString tipFor(const Error& error) const;

    LinkStateLabel* m_state = nullptr;
    PortBox* m_port = nullptr;
    LineForm* m_line = nullptr;
    QPushButton* m_connect = nullptr;
    QPushButton* m_disconnect = nullptr;
    QPushButton* m_scanButton = nullptr;
    QPushButton* m_recover = nullptr;
    QPushButton* m_powerCycle = nullptr;
    QLabel* m_advice = nullptr;
    Scan* m_scan = nullptr; ///< a child while it runs
    bool m_isRecovering = false; ///< what the scan finds is connected to
    LineChange m_change;
    QString m_notice; ///< of this panel: a bad address, the end of a scan; "" when out of date
};

} // namespace trex
