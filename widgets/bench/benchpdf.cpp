// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/bench/benchpdf.h"

#include "protocol/codec/parametertable.h"
#include "protocol/savefile.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextObjectInterface>
#include <QTextTable>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

struct BenchPdf {
    Q_DECLARE_TR_FUNCTIONS(BenchPdf)
};

// Of the printed page, which is white whatever the theme is.
const QColor kInk(u"#1F2328"_s);
const QColor kDim(u"#59636E"_s);
const QColor kRule(u"#D8DEE4"_s);
const QColor kGood(u"#1A7F37"_s);
const QColor kBad(u"#C4232B"_s);

constexpr int kPlotType = QTextFormat::UserObject + 1;
constexpr int kSvgProperty = QTextFormat::UserProperty + 1;
constexpr int kTitleProperty = QTextFormat::UserProperty + 2;
constexpr int kDpi = 300;
constexpr double kMarginMm = 16.0;
constexpr double kBodyPoints = 9.0;

/// Draws a plot's SVG with its title, which no page end comes between, where the text has its place
/// for it.
class PlotObject : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    using QObject::QObject;
    QSizeF intrinsicSize(QTextDocument* document, int /*position*/,
                         const QTextFormat& format) override
    {
        const QSize size = QSvgRenderer(format.property(kSvgProperty).toByteArray()).defaultSize();
        const double width = document->textWidth() - 2.0 * document->documentMargin();
        return {width, kTitleHeight + width * size.height() / std::max(size.width(), 1)};
    }
    void drawObject(QPainter* painter, const QRectF& rect, QTextDocument* document,
                    int /*position*/, const QTextFormat& format) override
    {
        painter->save();
        QFont font = document->defaultFont();
        font.setPointSizeF(12.0);
        font.setWeight(QFont::DemiBold);
        painter->setFont(font);
        painter->setPen(kInk);
        painter->drawText(QRectF(rect.topLeft(), QSizeF(rect.width(), kTitleHeight * 0.9)),
                          Qt::AlignLeft | Qt::AlignBottom,
                          format.property(kTitleProperty).toString());
        painter->restore();
        QSvgRenderer(format.property(kSvgProperty).toByteArray())
            .render(painter, rect.adjusted(0.0, kTitleHeight, 0.0, 0.0));
    }

private:
    static constexpr double kTitleHeight = 0.36 * kDpi;
};

class Writer {
public:
    Writer(QTextDocument& document, const BenchOutcome& outcome, const BenchReport& report)
        : m_cursor(&document), m_outcome(outcome), m_report(report)
    {
    }
    void write();

private:
    [[nodiscard]] static QTextCharFormat format(double points, const QColor& colour, bool isBold)
    {
        QTextCharFormat result;
        result.setFontPointSize(points);
        result.setForeground(colour);
        result.setFontWeight(isBold ? QFont::DemiBold : QFont::Normal);
        return result;
    }
    void paragraph(const QString& text, const QTextCharFormat& as, double above = 2.0)
    {
        QTextBlockFormat block;
        block.setTopMargin(above * scale());
        block.setBottomMargin(2.0 * scale());
        m_cursor.movePosition(QTextCursor::End);
        m_cursor.insertBlock(block);
        m_cursor.insertText(printable(text), as);
    }
    void heading(const QString& text) { paragraph(text, format(12.0, kInk, true), 12.0); }
    /// Points to the document's units.
    [[nodiscard]] static double scale() { return kDpi / 72.0; }
    void table(const QStringList& header, const std::vector<QStringList>& rows,
               const std::vector<int>& widths, int verdictColumn = -1);
    void writeResults();
    void writePlots();
    void writeSettings();

    QTextCursor m_cursor;
    const BenchOutcome& m_outcome;
    const BenchReport& m_report;
};

void Writer::table(const QStringList& header, const std::vector<QStringList>& rows,
                   const std::vector<int>& widths, int verdictColumn)
{
    QTextTableFormat as;
    as.setBorderStyle(QTextFrameFormat::BorderStyle_None);
    as.setBorder(0);
    as.setCellPadding(1.6 * scale());
    as.setCellSpacing(0);
    as.setHeaderRowCount(header.isEmpty() ? 0 : 1);
    as.setWidth(QTextLength(QTextLength::PercentageLength, 100));
    QList<QTextLength> columns;
    for (const int width : widths) {
        columns << QTextLength(QTextLength::PercentageLength, width);
    }
    as.setColumnWidthConstraints(columns);
    m_cursor.movePosition(QTextCursor::End);
    const int first = header.isEmpty() ? 0 : 1;
    QTextTable* table = m_cursor.insertTable(int(rows.size()) + first, int(widths.size()), as);
    const auto cell = [&](int row, int column, const QString& text, const QTextCharFormat& how) {
        QTextTableCellFormat lined;
        lined.setBottomBorder(0.5 * scale());
        lined.setBottomBorderBrush(kRule);
        lined.setBottomBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        table->cellAt(row, column).setFormat(lined);
        table->cellAt(row, column).firstCursorPosition().insertText(printable(text), how);
    };
    for (int column = 0; column < header.size(); ++column) {
        cell(0, column, header.at(column), format(kBodyPoints, kDim, true));
    }
    for (int row = 0; row < int(rows.size()); ++row) {
        const QStringList& texts = rows.at(std::size_t(row));
        for (int column = 0; column < int(widths.size()); ++column) {
            const bool isVerdict = column == verdictColumn;
            const QString& text = texts.at(column);
            const QColor colour = !isVerdict ? kInk
                : text.startsWith(u'✔')      ? kGood
                : text.startsWith(u'○')      ? kDim
                                             : kBad;
            cell(row + first, column, text, format(kBodyPoints, colour, false));
        }
    }
    m_cursor.movePosition(QTextCursor::End);
}

void Writer::write()
{
    m_cursor.insertText(printable(m_outcome.profile.name), format(19.0, kInk, true));
    paragraph(m_outcome.profile.description, format(kBodyPoints, kDim, false));
    const BenchVerdict verdict = m_outcome.verdict();
    const QColor& colour = verdict == BenchVerdict::Passed ? kGood
        : verdict == BenchVerdict::Failed                  ? kBad
                                                           : kInk;
    paragraph(signOf(verdict) + u' ' + m_outcome.verdictText(), format(11.0, colour, true), 8.0);
    if (m_outcome.isDryRun) {
        paragraph(BenchPdf::tr("▲ Dry run on the simulated controller and its motors: a "
                               "prediction. No real motor was moved or measured."),
                  format(kBodyPoints, kBad, true));
    }
    std::vector<QStringList> facts;
    for (const auto& [label, value] : factsOf(m_outcome, m_report)) {
        facts.push_back({label, value});
    }
    table({}, facts, {22, 78});
    writeResults();
    writePlots();
    writeSettings();
    heading(BenchPdf::tr("Events"));
    std::vector<QStringList> events;
    constexpr std::size_t kMost = 300;
    for (const BenchTrace::Event& event : m_outcome.trace.events) {
        if (events.size() < kMost) {
            events.push_back({QString::number(event.seconds, 'f', 2), event.text});
        }
    }
    table({BenchPdf::tr("Time, s"), BenchPdf::tr("Event")}, events, {14, 86});
    heading(BenchPdf::tr("The test as it was run"));
    QTextCharFormat code = format(7.0, kInk, false);
    code.setFontFamilies({u"monospace"_s});
    code.setFontFixedPitch(true);
    const QString profile = QString::fromUtf8(writeBenchProfile(m_outcome.profile)).trimmed();
    paragraph(QString(profile).replace(u'\n', QChar(QChar::LineSeparator)), code);
    heading(BenchPdf::tr("What such a test can know"));
    paragraph(knowledgeText(), format(kBodyPoints, kInk, false));
}

void Writer::writeResults()
{
    heading(BenchPdf::tr("Results"));
    std::vector<QStringList> rows;
    for (const BenchResult& result : m_outcome.results) {
        rows.push_back({result.title, valueText(result).replace(u' ', QChar(QChar::Nbsp)),
                        expectedText(result).replace(u' ', QChar(QChar::Nbsp)),
                        signOf(result.verdict) + u' ' + textOf(result.verdict), result.note});
    }
    table({BenchPdf::tr("Result"), BenchPdf::tr("Value"), BenchPdf::tr("Expected"),
           BenchPdf::tr("Verdict"), BenchPdf::tr("Rests on")},
          rows, {27, 19, 16, 14, 24}, 3);
    const auto proposals = proposalsOf(m_outcome);
    if (!proposals.empty()) {
        heading(BenchPdf::tr("Proposed settings"));
        paragraph(BenchPdf::tr("What follows from the results. Nothing of it was written to the "
                               "controller."),
                  format(kBodyPoints, kDim, false));
        rows.clear();
        for (const ProposalText& proposal : proposals) {
            rows.push_back({proposal.title, proposal.value, proposal.reason});
        }
        table({BenchPdf::tr("Parameter"), BenchPdf::tr("Proposal"), BenchPdf::tr("Reason")}, rows,
              {30, 16, 54});
    }
}

void Writer::writePlots()
{
    for (const BenchPlot& plot : plotsOf(m_outcome)) {
        QTextCharFormat object;
        object.setProperty(kTitleProperty, printable(plot.title));
        object.setObjectType(kPlotType);
        object.setProperty(kSvgProperty, plot.svg);
        m_cursor.movePosition(QTextCursor::End);
        m_cursor.insertBlock(QTextBlockFormat());
        m_cursor.insertText(QString(QChar::ObjectReplacementCharacter), object);
    }
}

void Writer::writeSettings()
{
    if (m_report.settings.parameters.empty()) {
        return;
    }
    heading(BenchPdf::tr("Settings of the controller"));
    std::vector<QStringList> rows;
    for (const auto& [number, raw] : m_report.settings.parameters) {
        const ParameterRow* row = findParameter(number);
        if (row != nullptr && !row->isTrigger) {
            rows.push_back({QCoreApplication::translate("Parameters", row->title),
                            parameterText(*row, raw, m_outcome.trace.model), QString::number(raw)});
        }
    }
    table({BenchPdf::tr("Parameter"), BenchPdf::tr("Value"), BenchPdf::tr("Raw")}, rows,
          {60, 26, 14});
}

/// Page by page, with its number below.
void print(QTextDocument& document, QPdfWriter& pdf, const QSizeF& page)
{
    QPainter painter(&pdf);
    const int pages = document.pageCount();
    for (int i = 0; i < pages; ++i) {
        if (i > 0) {
            pdf.newPage();
        }
        painter.save();
        painter.translate(0.0, -i * page.height());
        QAbstractTextDocumentLayout::PaintContext context;
        context.clip = QRectF(0.0, i * page.height(), page.width(), page.height());
        context.palette.setColor(QPalette::Text, kInk);
        painter.setClipRect(context.clip);
        document.documentLayout()->draw(&painter, context);
        painter.restore();
        painter.setPen(kDim);
        QFont font = document.defaultFont();
        font.setPointSizeF(8.0);
        painter.setFont(font);
        painter.drawText(QRectF(0.0, page.height(), page.width(), kDpi * 0.3),
                         Qt::AlignRight | Qt::AlignBottom,
                         BenchPdf::tr("%1 of %2").arg(i + 1).arg(pages));
    }
}

} // namespace

Result<void> savePdf(const QString& path, const BenchOutcome& outcome, const BenchReport& report)
{
    SaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        return fail(ErrorCode::FileUnwritable, u"%1: %2"_s.arg(path, file.errorString()));
    }
    {
        QPdfWriter pdf(&file);
        pdf.setResolution(kDpi);
        pdf.setPageSize(QPageSize(QPageSize::A4));
        pdf.setPageMargins({kMarginMm, kMarginMm, kMarginMm, kMarginMm}, QPageLayout::Millimeter);
        pdf.setTitle(BenchPdf::tr("Bench test: %1").arg(outcome.profile.name));
        pdf.setCreator(report.program);
        PlotObject plots;
        QTextDocument document;
        document.documentLayout()->setPaintDevice(&pdf);
        document.documentLayout()->registerHandler(kPlotType, &plots);
        document.setDocumentMargin(0.0);
        QFont font(u"sans-serif"_s);
        font.setPointSizeF(kBodyPoints);
        document.setDefaultFont(font);
        QSizeF page = pdf.pageLayout().paintRectPixels(kDpi).size();
        page.rheight() -= kDpi * 0.35; // for the page's number
        document.setPageSize(page);
        Writer(document, outcome, report).write();
        print(document, pdf, page);
    }
    if (!file.commit()) {
        return fail(ErrorCode::FileUnwritable, u"%1: %2"_s.arg(path, file.errorString()));
    }
    return {};
}

} // namespace trex

#include "benchpdf.moc"
