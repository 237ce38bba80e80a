<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>Recording</name>
    <message numerus="yes">
        <source>The recording is damaged: %n parts are left out.</source>
        <translation>
            <numerusform>The recording is damaged: %n part is left out.</numerusform>
            <numerusform>The recording is damaged: %n parts are left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::CurrentsPanel</name>
    <message numerus="yes">
        <source>%n sample(s) exported to %1.</source>
        <translation>
            <numerusform>%n sample exported to %1.</numerusform>
            <numerusform>%n samples exported to %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recording ended: %n sample(s) in %1.</source>
        <translation>
            <numerusform>Recording ended: %n sample in %1.</numerusform>
            <numerusform>Recording ended: %n samples in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::Indicator</name>
    <message numerus="yes">
        <source>%1, seen %n time(s)</source>
        <translation>
            <numerusform>%1, seen once</numerusform>
            <numerusform>%1, seen %n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::LinkStatusBar</name>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::PlotsPanel</name>
    <message numerus="yes">
        <source>%n row(s) of samples exported to %1.</source>
        <translation>
            <numerusform>%n row of samples exported to %1.</numerusform>
            <numerusform>%n rows of samples exported to %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) of samples copied.</source>
        <translation>
            <numerusform>%n row of samples copied.</numerusform>
            <numerusform>%n rows of samples copied.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::RecordingActions</name>
    <message numerus="yes">
        <source>%n minute(s)</source>
        <translation>
            <numerusform>%n minute</numerusform>
            <numerusform>%n minutes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::RecordingWindow</name>
    <message numerus="yes">
        <source>%n row(s) exported to %1.</source>
        <translation>
            <numerusform>%n row exported to %1.</numerusform>
            <numerusform>%n rows exported to %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::Recordings</name>
    <message numerus="yes">
        <source>Recording ended: %n sample(s) in %1.</source>
        <translation>
            <numerusform>Recording ended: %n sample in %1.</numerusform>
            <numerusform>Recording ended: %n samples in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::SessionRecorder</name>
    <message numerus="yes">
        <source>The disk was too slow: %n events or packets were left out so far.</source>
        <translation>
            <numerusform>The disk was too slow: %n event or packet was left out so far.</numerusform>
            <numerusform>The disk was too slow: %n events or packets were left out so far.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::StatusPanel</name>
    <message numerus="yes">
        <source>Seen %n time(s), first %1, last %2.</source>
        <translation>
            <numerusform>Seen %n time, first %1, last %2.</numerusform>
            <numerusform>Seen %n times, first %1, last %2.</numerusform>
        </translation>
    </message>
</context>
</TS>
