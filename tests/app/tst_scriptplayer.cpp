// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/scriptplayer.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/frameticker.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QShortcut>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QVBoxLayout>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

/// A small window with one of everything that scripts touch.
struct Window : QMainWindow {
    Window()
    {
        setObjectName(u"mainWindow"_s);
        auto* centre = new QWidget(this);
        auto* layout = new QVBoxLayout(centre);
        for (QWidget* widget :
             std::initializer_list<QWidget*>{&button, &disabled, &twin1, &twin2, &slider, &spin,
                                             &edit, &combo, &check, &label}) {
            layout->addWidget(widget);
        }
        setCentralWidget(centre);
        button.setObjectName(u"w.button"_s);
        disabled.setObjectName(u"w.disabled"_s);
        disabled.setEnabled(false);
        twin1.setObjectName(u"w.twin"_s);
        twin2.setObjectName(u"w.twin"_s);
        slider.setObjectName(u"w.slider"_s);
        slider.setRange(-127, 127);
        spin.setObjectName(u"w.spin"_s);
        edit.setObjectName(u"w.edit"_s);
        combo.setObjectName(u"w.combo"_s);
        combo.addItem(u"One"_s, 1);
        combo.addItem(u"Two"_s, u"second"_s);
        check.setObjectName(u"w.check"_s);
        label.setObjectName(u"w.label"_s);
        label.setText(u"2.20 A"_s);
        for (const auto& name : {u"left"_s, u"right"_s}) {
            auto* dock = new QDockWidget(name, this);
            auto* inner = new QPushButton(name, dock);
            inner->setObjectName(u"w."_s + name);
            dock->setWidget(inner);
            addDockWidget(Qt::LeftDockWidgetArea, dock);
            docks << dock;
        }
        tabifyDockWidget(docks.at(0), docks.at(1));
        docks.at(0)->raise();
        show();
    }
    QPushButton button, disabled, twin1, twin2;
    QSlider slider{Qt::Horizontal};
    QSpinBox spin;
    QLineEdit edit;
    QComboBox combo;
    QCheckBox check;
    QLabel label;
    QList<QDockWidget*> docks;
};

} // namespace

class TestScriptPlayer : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void click_pressesOnce();
    void click_failsAndSaysWhy_data();
    void click_failsAndSaysWhy();
    void click_turnsToTheTabInFront();
    void click_opensAClosedDock();
    void set_firesTheSignalsOfAPerson();
    void set_findsComboItemsByTextAndData();
    void set_refusesWhatAPersonCouldNotEnter_data();
    void set_refusesWhatAPersonCouldNotEnter();
    void key_reachesShortcuts();
    void waitFor_waitsAndTimesOut();
    void expect_comparesNumbersTextsAndBooleans();
    void repeat_goesRoundUntilTheConditionHolds();
    void repeat_failsAfterItsRounds();
    void dialog_answersTheOneThatIsOpen();
    void file_answersTheQuestion();
    void file_failsWhenNothingIsAsked();
    void screenshot_writesThePicture();
    void window_isMinimisedAndRestored();
    void failure_endsTheScript();
    void emptyScript_passes();

private:
    void play(const QByteArray& steps);
    [[nodiscard]] QString lastMessage() const { return m_player->records().back().message; }
    std::unique_ptr<Window> m_window;
    std::unique_ptr<FileDialogs> m_dialogs;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<ScriptPlayer> m_player;
};

void TestScriptPlayer::init()
{
    m_window = std::make_unique<Window>();
    m_dialogs = std::make_unique<FileDialogs>();
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void TestScriptPlayer::cleanup()
{
    m_player.reset();
    m_window.reset();
}

void TestScriptPlayer::play(const QByteArray& steps)
{
    Result<Script> script = parseScript("{\"steps\":[" + steps + "]}", u"test"_s);
    QVERIFY2(script, script ? "" : qPrintable(script.error().context));
    m_player = std::make_unique<ScriptPlayer>(std::move(*script), *m_dialogs, m_folder->path());
    QSignalSpy finished(m_player.get(), &ScriptPlayer::finished);
    m_player->start();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 20'000);
}

void TestScriptPlayer::click_pressesOnce()
{
    QSignalSpy clicked(&m_window->button, &QPushButton::clicked);
    play(R"({"click":"w.button"})");
    QVERIFY(m_player->isPassed());
    QCOMPARE(clicked.count(), 1);
    QCOMPARE(m_player->records().size(), 1);
    QCOMPARE(m_player->records().front().action, u"click"_s);
    QVERIFY(m_player->records().front().startMs > 0);
}

void TestScriptPlayer::click_failsAndSaysWhy_data()
{
    QTest::addColumn<QByteArray>("step");
    QTest::addColumn<QString>("said");
    QTest::newRow("missing") << QByteArray(R"({"click":"w.buton"})")
                             << u"There is no object \"w.buton\""_s;
    QTest::newRow("near names") << QByteArray(R"({"click":"w.buton"})") << u"w.button"_s;
    QTest::newRow("ambiguous") << QByteArray(R"({"click":"w.twin"})") << u"ambiguous"_s;
    QTest::newRow("disabled") << QByteArray(R"({"click":"w.disabled","timeoutMs":60})")
                              << u"disabled"_s;
    QTest::newRow("set disabled") << QByteArray(
        R"({"set":{"object":"w.disabled","value":true},"timeoutMs":60})")
                                  << u"disabled"_s;
}

void TestScriptPlayer::click_failsAndSaysWhy()
{
    QFETCH(QByteArray, step);
    QFETCH(QString, said);
    play(step);
    QCOMPARE(m_player->failedStep(), 0);
    QVERIFY2(lastMessage().contains(said), qPrintable(lastMessage()));
}

void TestScriptPlayer::click_turnsToTheTabInFront()
{
    const QRect window = m_window->rect();
    QVERIFY(!window.intersects(m_window->docks.at(1)->geometry()));
    auto* inner = qobject_cast<QPushButton*>(m_window->docks.at(1)->widget());
    QSignalSpy clicked(inner, &QPushButton::clicked);
    play(R"({"click":"w.right"})");
    QVERIFY(m_player->isPassed());
    QCOMPARE(clicked.count(), 1);
    QVERIFY(window.intersects(m_window->docks.at(1)->geometry()));
}

void TestScriptPlayer::click_opensAClosedDock()
{
    m_window->docks.at(1)->close();
    play(R"({"click":"w.right"})");
    QVERIFY(m_player->isPassed());
    QVERIFY(m_window->docks.at(1)->isVisible());
}

void TestScriptPlayer::set_firesTheSignalsOfAPerson()
{
    QSignalSpy moved(&m_window->slider, &QSlider::sliderMoved);
    QSignalSpy changed(&m_window->slider, &QSlider::valueChanged);
    QSignalSpy edited(&m_window->edit, &QLineEdit::textEdited);
    QSignalSpy finished(&m_window->edit, &QLineEdit::editingFinished);
    QSignalSpy spun(&m_window->spin, &QSpinBox::valueChanged);
    QSignalSpy activated(&m_window->combo, &QComboBox::activated);
    QSignalSpy checked(&m_window->check, &QCheckBox::clicked);
    play(R"({"set":{"object":"w.slider","value":-64}}, {"set":{"object":"w.edit","value":"abc"}},
            {"set":{"object":"w.spin","value":7}}, {"set":{"object":"w.combo","value":"Two"}},
            {"set":{"object":"w.check","value":true}}, {"set":{"object":"w.check","value":true}},
            {"set":{"object":"w.label","property":"text","value":"new"}})");
    QVERIFY2(m_player->isPassed(), qPrintable(lastMessage()));
    QCOMPARE(m_window->slider.value(), -64);
    QCOMPARE(moved.count(), 1);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(m_window->edit.text(), u"abc"_s);
    QCOMPARE(edited.count(), 1);
    QCOMPARE(finished.count(), 1);
    QCOMPARE(spun.count(), 1);
    QCOMPARE(m_window->combo.currentIndex(), 1);
    QCOMPARE(activated.count(), 1);
    QVERIFY(m_window->check.isChecked());
    QCOMPARE(checked.count(), 1); // the second step found it checked already
    QCOMPARE(m_window->label.text(), u"new"_s);
}

void TestScriptPlayer::set_findsComboItemsByTextAndData()
{
    play(R"({"set":{"object":"w.combo","value":"second"}},
            {"expect":{"object":"w.combo","property":"currentIndex","equals":1}},
            {"set":{"object":"w.combo","value":1}},
            {"expect":{"object":"w.combo","property":"text","equals":"One"}})");
    QVERIFY2(m_player->isPassed(), qPrintable(lastMessage()));
}

void TestScriptPlayer::set_refusesWhatAPersonCouldNotEnter_data()
{
    QTest::addColumn<QByteArray>("step");
    QTest::newRow("slider beyond") << QByteArray(R"({"set":{"object":"w.slider","value":200}})");
    QTest::newRow("slider text") << QByteArray(R"({"set":{"object":"w.slider","value":"x"}})");
    QTest::newRow("spin beyond") << QByteArray(R"({"set":{"object":"w.spin","value":1000}})");
    QTest::newRow("combo unknown") << QByteArray(R"({"set":{"object":"w.combo","value":"Three"}})");
    QTest::newRow("check number") << QByteArray(R"({"set":{"object":"w.check","value":1}})");
    QTest::newRow("label") << QByteArray(R"({"set":{"object":"w.label","value":"x"}})");
    QTest::newRow("no property") << QByteArray(
        R"({"set":{"object":"w.label","property":"raw","value":1}})");
}

void TestScriptPlayer::set_refusesWhatAPersonCouldNotEnter()
{
    QFETCH(QByteArray, step);
    play(step);
    QCOMPARE(m_player->failedStep(), 0);
    QVERIFY(!lastMessage().isEmpty());
}

void TestScriptPlayer::key_reachesShortcuts()
{
    QShortcut shortcut(QKeySequence(Qt::CTRL | Qt::Key_K), m_window.get());
    QSignalSpy activated(&shortcut, &QShortcut::activated);
    play(R"({"key":{"object":"mainWindow","sequence":"Ctrl+K"}},
            {"key":{"object":"w.edit","sequence":"A"}},
            {"key":{"object":"w.check","sequence":"Space"}})");
    QVERIFY2(m_player->isPassed(), qPrintable(lastMessage()));
    QCOMPARE(activated.count(), 1);
    QCOMPARE(m_window->edit.text(), u"a"_s);
    QVERIFY(m_window->check.isChecked());
}

void TestScriptPlayer::waitFor_waitsAndTimesOut()
{
    QTimer::singleShot(100, &m_window->label, [this] { m_window->label.setText(u"done"_s); });
    play(R"({"waitFor":{"object":"w.label","property":"text","equals":"done"}},
            {"waitFor":{"object":"w.label","property":"text","equals":"more"},"timeoutMs":60})");
    QCOMPARE(m_player->failedStep(), 1);
    QVERIFY(m_player->records().at(0).ok);
    QVERIFY(m_player->records().at(0).milliseconds >= 50);
    QVERIFY2(lastMessage().contains(u"60 ms"_s) && lastMessage().contains(u"\"done\""_s),
             qPrintable(lastMessage()));
}

void TestScriptPlayer::expect_comparesNumbersTextsAndBooleans()
{
    play(R"({"expect":{"object":"w.label","property":"text","min":2.2,"max":2.3}},
            {"expect":{"object":"w.label","property":"text","matches":"\\d A$"}},
            {"expect":{"object":"w.disabled","property":"enabled","equals":false}},
            {"expect":{"object":"w.slider","property":"maximum","equals":127}},
            {"expect":{"object":"w.label","property":"text","min":2.3}})");
    QCOMPARE(m_player->failedStep(), 4);
    play(R"({"expect":{"object":"w.label","property":"nothing","equals":1}})");
    QVERIFY(lastMessage().contains(u"no property"_s));
}

void TestScriptPlayer::repeat_goesRoundUntilTheConditionHolds()
{
    connect(&m_window->button, &QPushButton::clicked, &m_window->spin,
            [this] { m_window->spin.setValue(m_window->spin.value() + 1); });
    play(R"({"repeat":{"until":{"object":"w.spin","property":"value","equals":3},"max":5,
            "steps":[{"click":"w.button"},{"sleepMs":1}]}}, {"sleepMs":1})");
    QVERIFY2(m_player->isPassed(), qPrintable(lastMessage()));
    QCOMPARE(m_window->spin.value(), 3);
    QCOMPARE(m_player->records().size(), 2);
}

void TestScriptPlayer::repeat_failsAfterItsRounds()
{
    play(R"({"repeat":{"until":{"object":"w.spin","property":"value","equals":3},"max":2,
            "steps":[{"sleepMs":1}]}})");
    QCOMPARE(m_player->failedStep(), 0);
    QVERIFY2(lastMessage().contains(u"2 rounds"_s), qPrintable(lastMessage()));
    play(R"({"repeat":{"until":{"object":"w.spin","property":"value","equals":3},"max":2,
            "steps":[{"sleepMs":1},{"click":"w.disabled","timeoutMs":60}]}})");
    QVERIFY2(lastMessage().contains(u"round 1, step 1 (click)"_s), qPrintable(lastMessage()));
}

void TestScriptPlayer::dialog_answersTheOneThatIsOpen()
{
    auto* dialog = new QDialog(m_window.get());
    QSignalSpy finished(dialog, &QDialog::finished);
    connect(&m_window->button, &QPushButton::clicked, dialog, &QDialog::open);
    play(R"({"click":"w.button"},{"dialog":"accept"})");
    QVERIFY2(m_player->isPassed(), qPrintable(lastMessage()));
    QCOMPARE(finished.value(0).value(0).toInt(), int{QDialog::Accepted});
    play(R"({"dialog":"accept","timeoutMs":20})");
    QCOMPARE(m_player->failedStep(), 0);
    play(R"({"click":"w.button"},{"click":"w.check"})");
    QVERIFY2(lastMessage().contains(u"behind a dialog"_s), qPrintable(lastMessage()));
}

void TestScriptPlayer::file_answersTheQuestion()
{
    QString chosen;
    connect(&m_window->button, &QPushButton::clicked, m_dialogs.get(), [this, &chosen] {
        m_dialogs->askSave(m_window.get(), u"Save"_s, u"a.json"_s, {},
                           [&chosen](const QString& path) { chosen = path; });
    });
    play(R"({"file":{"object":"w.button","path":"backup.json"}},{"sleepMs":1})");
    QVERIFY2(m_player->isPassed(), qPrintable(lastMessage()));
    QCOMPARE(chosen, u"backup.json"_s);
}

void TestScriptPlayer::file_failsWhenNothingIsAsked()
{
    play(R"({"file":{"object":"w.button","path":"backup.json"}})");
    QCOMPARE(m_player->failedStep(), 0);
    QVERIFY(!m_dialogs->isAnswerWaiting());
}

void TestScriptPlayer::screenshot_writesThePicture()
{
    play(R"({"screenshot":{"object":"mainWindow","file":"sub/main.png"}})");
    QVERIFY2(m_player->isPassed(), qPrintable(lastMessage()));
    QCOMPARE(m_player->screenshots(), QStringList{u"sub/main.png"_s});
    const QImage picture(m_folder->filePath(u"sub/main.png"_s));
    QCOMPARE(picture.size(), m_window->size() * m_window->devicePixelRatio());
}

void TestScriptPlayer::window_isMinimisedAndRestored()
{
    QVERIFY(!FrameTicker::isEverythingMinimised());
    play(R"({"window":"minimise"})");
    QVERIFY(m_player->isPassed());
    QVERIFY(m_window->isMinimized());
    QVERIFY(FrameTicker::isEverythingMinimised()); // nobody sees a frame
    play(R"({"window":"restore"})");
    QVERIFY(!m_window->isMinimized());
    QVERIFY(!FrameTicker::isEverythingMinimised());
}

void TestScriptPlayer::failure_endsTheScript()
{
    QSignalSpy clicked(&m_window->button, &QPushButton::clicked);
    play(R"({"sleepMs":1},{"click":"nowhere"},{"click":"w.button"})");
    QCOMPARE(m_player->failedStep(), 1);
    QCOMPARE(m_player->records().size(), 2);
    QCOMPARE(clicked.count(), 0);
}

void TestScriptPlayer::emptyScript_passes()
{
    play("");
    QVERIFY(m_player->isPassed());
    QVERIFY(m_player->records().empty());
}

QTEST_MAIN(TestScriptPlayer)
#include "tst_scriptplayer.moc"
