// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parameterfield.h"

class QCheckBox;

namespace trex {

/// One box for each of the five channels, with what the channel does. GUI thread.
class ChannelBitsField : public ParameterField {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ChannelBitsField)

public:
    ChannelBitsField(const ParameterRow& row, QWidget* parent);

protected:
    void display(std::optional<int> raw) override;
    void setWords(Words words) override;
    [[nodiscard]] QString storedText(int raw) const override;

private:
    void onClicked();

    std::vector<QCheckBox*> m_boxes;
    bool m_hasRawBeside = true;
};

} // namespace trex
