// SPDX-License-Identifier: GPL-3.0-or-later
// Bench tests as files: what a person writes is understood or refused with its line, what is
// written is read back, and a hostile file does no harm.
#include "protocol/storage/benchprofile.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

QByteArray profileWith(const QByteArray& steps, const QByteArray& more = {})
{
    return R"({"format":"trexpanel-bench-profile","version":1,"name":"Test",)" + more
        + R"("steps":[)" + steps + "]}";
}

} // namespace

class TestBenchProfile : public QObject {
    Q_OBJECT

private slots:
    void everyStep_isReadAndWrittenBack();
    void comments_stayWhereTheyStood();
    void mistake_isNamedWithItsPlace_data();
    void mistake_isNamedWithItsPlace();
    void plannedSeconds_countsRepetitions();
    void highestSpeed_looksIntoRepetitions();
    void file_isWrittenWhole();
    void damagedFile_isRefusedOrSound();
};

void TestBenchProfile::everyStep_isReadAndWrittenBack()
{
    const QByteArray json = profileWith(
        R"(
        {"do":"set","speed":40},
        {"do":"accelerate","motor":"1","speed":-127,"label":"hard"},
        {"do":"ramp","to":60,"seconds":3},
        {"do":"ramp","from":-5,"to":60,"seconds":0.5},
        {"do":"step","motor":"aux","speed":127,"seconds":1},
        {"do":"sine","middle":10,"amplitude":50,"period":2,"seconds":8,"limits":{"amperes":2.5,"forSeconds":0.2}},
        {"do":"hold","seconds":1.5},
        {"do":"brake","duty":64},
        {"do":"wait","for":"current-below","motor":"2","amperes":0.3,"seconds":2,"otherwise":"go-on"},
        {"do":"wait","for":"status","bit":"motor2-over-current","seconds":2},
        {"do":"wait","for":"channel-above","channel":3,"raw":4000,"seconds":2},
        {"do":"wait","for":"time","at":30,"seconds":20},
        {"do":"repeat","times":3,"steps":[{"do":"hold","seconds":1},{"do":"repeat","times":2,"steps":[{"do":"hold","seconds":0.1}]}]})",
        R"("analysis":"braking","motor":"both","supplyVolts":12.6,"limits":{"seconds":90,"ampereSeconds":50,"linkErrors":4,"staleSeconds":0.3,"overCurrent":false},"expect":{"a.b":{"minimum":-1,"maximum":2.5}},)");
    const auto profile = parseBenchProfile(json, u"p.json"_s);
    QVERIFY2(profile, profile ? "" : qPrintable(profile.error().context));
    QCOMPARE(profile->steps.size(), std::size_t(13));
    QCOMPARE(profile->analysis, BenchAnalysis::Braking);
    QCOMPARE(profile->supplyVolts, std::optional(12.6));
    QCOMPARE(profile->staleSeconds(), 0.3);
    QVERIFY(!profile->limits.overCurrentStops);
    QCOMPARE(profile->expect.at(u"a.b"_s).maximum, std::optional(2.5));
    QCOMPARE(profile->steps[1].motor, BenchMotor::Motor1);
    QCOMPARE(profile->steps[1].label, u"hard"_s);
    QVERIFY(!profile->steps[2].from);
    QCOMPARE(profile->steps[3].from, std::optional(-5));
    QCOMPARE(profile->steps[5].limits.amperes, std::optional(2.5));
    QVERIFY(!profile->steps[8].mustHappen);
    QCOMPARE(profile->steps[9].number, 7);
    QCOMPARE(profile->steps[10].threshold, 4000.0);
    QCOMPARE(profile->steps[12].steps[1].steps.size(), std::size_t(1));

    const QByteArray written = writeBenchProfile(*profile);
    const auto again = parseBenchProfile(written, u"again.json"_s);
    QVERIFY2(again, again ? "" : qPrintable(again.error().context));
    QVERIFY(*again == *profile);
    QCOMPARE(writeBenchProfile(*again), written);
}

void TestBenchProfile::comments_stayWhereTheyStood()
{
    const auto profile = parseBenchProfile(
        profileWith(R"({"do":"hold","why":"the gears settle","seconds":1,"zz":"last"})",
                    R"("who":"Ada","at":"bench 3","limits":{"amperes":2,"because":"the fuse"},)"),
        u"p.json"_s);
    QVERIFY2(profile, profile ? "" : qPrintable(profile.error().context));
    const QByteArray written = writeBenchProfile(*profile);
    QVERIFY2(written.contains(R"("name": "Test",
    "who": "Ada",
    "at": "bench 3",)"),
             written);
    QVERIFY2(
        written.contains(R"("do": "hold", "why": "the gears settle", "seconds": 1, "zz": "last")"),
        written);
    QVERIFY2(written.contains(R"("because": "the fuse")"), written);
    QVERIFY(*parseBenchProfile(written, {}) == *profile);
}

void TestBenchProfile::mistake_isNamedWithItsPlace_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("named");
    const auto step = [](const char* name, const QByteArray& text, const char* named) {
        QTest::newRow(name) << profileWith(QByteArray("\n{\"do\":\"hold\",\"seconds\":1},\n")
                                           + text)
                            << u"line 3"_s << QString::fromUtf8(named);
    };
    step("no action", R"({"seconds":1})", "steps.1.do");
    step("unknown action", R"({"do":"fly"})", "fly is not known; give set, accelerate");
    step("slip of a key", R"({"do":"hold","second":1})", "is seconds meant?");
    step("key of another step", R"({"do":"set","speed":1,"duty":5})", "steps.1.duty");
    step("too fast", R"({"do":"set","speed":128})", "128 is out of range (-127…127)");
    step("half a speed", R"({"do":"set","speed":0.5})", "must be a whole number");
    step("speed as text", R"({"do":"set","speed":"40"})", "must be a whole number, but is a text");
    step("no time", R"({"do":"hold"})", "steps.1.seconds: is missing");
    step("negative time", R"({"do":"hold","seconds":-1})", "out of range");
    step("other motor", R"({"do":"set","speed":1,"motor":"3"})", "give 1, 2, both, aux");
    step("aux current",
         R"({"do":"wait","for":"current-above","motor":"aux","amperes":1,"seconds":1})",
         "the current of the auxiliary motor is not measured");
    step("no such bit", R"({"do":"wait","for":"status","bit":"heat","seconds":1})",
         "give uart-error, motor1-fault");
    step("limit in another limit", R"({"do":"hold","seconds":1,"limits":{"forSeconds":1}})",
         "amperes is missing");
    step("a command", R"({"do":"hold","seconds":1,"exec":["rm"]})", "is not known here");
    QTest::newRow("in a repetition") << profileWith(
        "\n{\"do\":\"repeat\",\"times\":2,\"steps\":[\n{\"do\":\"hold\",\"seconds\":\n0}]}")
                                     << u"line 3"_s << u"steps.0.steps.0.seconds"_s;
    const auto whole = [](const char* name, const QByteArray& text, const char* named) {
        QTest::newRow(name) << text << QString() << QString::fromUtf8(named);
    };
    whole("aux reverse",
          profileWith(R"({"do":"set","motor":"aux","speed":-1},{"do":"hold","seconds":1})"),
          "step 1: the auxiliary motor has no reverse");
    whole("aux brake",
          profileWith(R"({"do":"brake","motor":"aux","duty":1},{"do":"hold","seconds":1})"),
          "step 1: the auxiliary motor cannot brake");
    whole("sine beyond",
          profileWith(R"({"do":"sine","middle":100,"amplitude":50,"period":1,"seconds":1})"),
          "more than full speed");
    whole("no steps", profileWith(""), "has no steps");
    whole("nothing repeated", profileWith(R"({"do":"repeat","times":2,"steps":[]})"),
          "nothing to repeat");
    whole("no time repeated",
          profileWith(R"({"do":"repeat","times":99999,"steps":[{"do":"set","speed":1}]})"),
          "takes no time");
    whole("longer than a day",
          profileWith(R"({"do":"repeat","times":2,"steps":[{"do":"hold","seconds":80000}]})"),
          "longer than a day");
    whole(
        "four deep",
        profileWith(
            R"({"do":"repeat","times":1,"steps":[{"do":"repeat","times":1,"steps":[{"do":"repeat","times":1,"steps":[{"do":"repeat","times":1,"steps":[{"do":"hold","seconds":1}]}]}]}]})"),
        "three deep");
    whole("twice", profileWith(R"({"do":"set","speed":1,"speed":100})"), "stands twice");
    whole("newer", R"({"format":"trexpanel-bench-profile","version":2,"name":"x","steps":[]})",
          "2 is newer than this program");
    whole("a configuration", R"({"format":"trexpanel-configuration","version":1})",
          "no bench test");
    whole("no name", R"({"format":"trexpanel-bench-profile","version":1,"steps":[]})",
          "name: is missing");
    whole("empty expectation", profileWith(R"({"do":"hold","seconds":1})", R"("expect":{"x":{}},)"),
          "needs minimum, maximum or both");
    whole(
        "crossed expectation",
        profileWith(R"({"do":"hold","seconds":1})", R"("expect":{"x":{"minimum":2,"maximum":1}},)"),
        "is above maximum");
    whole("empty", "", "empty");
    whole("not JSON", "set 40", "line 1, column");
    whole("too large", QByteArray(300'000, ' '), "larger than 256 KiB");
}

void TestBenchProfile::mistake_isNamedWithItsPlace()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, line);
    QFETCH(QString, named);
    const auto profile = parseBenchProfile(json, u"p.json"_s);
    QVERIFY(!profile);
    QCOMPARE(profile.error().code, ErrorCode::FileMalformed);
    const QString text = profile.error().context;
    QVERIFY2(text.startsWith(u"p.json"_s) && text.contains(line) && text.contains(named),
             qPrintable(text));
}

void TestBenchProfile::plannedSeconds_countsRepetitions()
{
    const auto profile =
        parseBenchProfile(profileWith(R"({"do":"set","speed":5},{"do":"hold","seconds":2},
            {"do":"repeat","times":10,"steps":[{"do":"ramp","to":9,"seconds":1},
                {"do":"wait","for":"time","at":1,"seconds":0.5}]})"),
                          {});
    QCOMPARE(plannedSeconds(profile.value()), 17.0);
}

void TestBenchProfile::highestSpeed_looksIntoRepetitions()
{
    const auto profile = parseBenchProfile(
        profileWith(R"({"do":"set","motor":"1","speed":-50},{"do":"brake","motor":"2","duty":127},
            {"do":"repeat","times":1,"steps":[{"do":"sine","motor":"1","middle":-20,"amplitude":40,"period":1,"seconds":1}]})"),
        {});
    QVERIFY2(profile, profile ? "" : qPrintable(profile.error().context));
    QCOMPARE(highestSpeed(*profile, MotorId::Motor1), 60);
    QCOMPARE(highestSpeed(*profile, MotorId::Motor2), 0); // braking drives nothing
    QCOMPARE(highestSpeed(*profile, MotorId::Aux), 0);
}

void TestBenchProfile::file_isWrittenWhole()
{
    const QTemporaryDir folder;
    const auto profile = parseBenchProfile(profileWith(R"({"do":"hold","seconds":1})"), {}).value();
    const QString path = folder.filePath(u"p.json"_s);
    QVERIFY(saveBenchProfile(profile, path));
    QVERIFY(*loadBenchProfile(path) == profile);
    QCOMPARE(loadBenchProfile(folder.filePath(u"none"_s)).error().code, ErrorCode::FileUnreadable);
    QCOMPARE(loadBenchProfile(u"/dev/zero"_s).error().code, ErrorCode::FileUnreadable);
    QCOMPARE(loadBenchProfile(folder.path()).error().code, ErrorCode::FileUnreadable);
    QCOMPARE(saveBenchProfile(profile, folder.filePath(u"no/p"_s)).error().code,
             ErrorCode::FileUnwritable);
}

/// Every byte of a sound file replaced and cut off in turn: refused, or sound and within limits.
void TestBenchProfile::damagedFile_isRefusedOrSound()
{
    const QByteArray sound = profileWith(
        R"({"do":"repeat","times":3,"steps":[{"do":"ramp","to":60,"seconds":3},{"do":"wait","for":"status","bit":"uart-error","seconds":2}]})");
    QVERIFY(parseBenchProfile(sound, {}));
    int refused = 0;
    for (qsizetype i = 0; i < sound.size(); ++i) {
        for (const char byte : {'9', '"', '}', '-', '\0', '\xff'}) {
            QByteArray damaged = sound;
            damaged[i] = byte;
            const auto profile = parseBenchProfile(damaged, {});
            refused += profile ? 0 : 1;
            if (profile) {
                QVERIFY(validate(*profile));
                QVERIFY(plannedSeconds(*profile) <= BenchProfile::kLongestSeconds);
            }
        }
        QVERIFY(!parseBenchProfile(sound.first(i), {}));
    }
    QVERIFY(refused > sound.size());
}

QTEST_GUILESS_MAIN(TestBenchProfile)
#include "tst_benchprofile.moc"
