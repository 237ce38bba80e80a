<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Advice</name>
    <message>
        <source>With the serial timeout off, motors keep running if the line is lost.</source>
        <translation>Ohne serielle Zeitüberwachung laufen die Motoren bei Leitungsausfall weiter.</translation>
    </message>
    <message>
        <source>Both required and ignored: %1.</source>
        <translation>Zugleich erforderlich und ignoriert: %1.</translation>
    </message>
    <message>
        <source>Motor %1 gets %2 kHz; the TReX Jr&apos;s motor driver is rated for 10 kHz and may overheat.</source>
        <translation>Motor %1 erhält %2 kHz; der Motortreiber des TReX Jr ist für 10 kHz ausgelegt und kann überhitzen.</translation>
    </message>
    <message>
        <source>The new device number acts at once: after writing, connect again with device number %1.</source>
        <translation>Die neue Gerätenummer wirkt sofort: nach dem Schreiben mit Gerätenummer %1 neu verbinden.</translation>
    </message>
    <message>
        <source>Pololu packets reach this controller under number %1 from then on; compact packets always do.</source>
        <translation>Pololu-Pakete erreichen diesen Controller danach unter Nummer %1; kompakte Pakete erreichen ihn immer.</translation>
    </message>
    <message>
        <source>After the power cycle, connect with %1, or nothing answers.</source>
        <translation>Nach dem Aus- und Einschalten mit %1 verbinden, sonst antwortet nichts.</translation>
    </message>
    <message>
        <source>Firmware before 1.2 runs at half of %1 baud.</source>
        <translation>Firmware vor 1.2 arbeitet mit der Hälfte von %1 Baud.</translation>
    </message>
    <message>
        <source>In joint mode there are no current readings, and motor 1 commands drive both bridges.</source>
        <translation>Im gemeinsamen Modus gibt es keine Strommesswerte, und Befehle für Motor 1 steuern beide H-Brücken.</translation>
    </message>
    <message>
        <source>The inputs have a calibration of their own for RC and for analog: after the power cycle the other one is in force.</source>
        <translation>Die Eingänge haben je eine eigene Kalibrierung für RC und für Analog: nach dem Aus- und Einschalten gilt die andere.</translation>
    </message>
    <message>
        <source>%1 ms are no longer than this program waits for a reply (%2 ms): one lost reply may stop the motors.</source>
        <translation>%1 ms sind nicht länger, als dieses Programm auf eine Antwort wartet (%2 ms): Eine verlorene Antwort kann die Motoren anhalten.</translation>
    </message>
    <message>
        <source>In joint mode no current is measured: the limit of motor %1 cannot act.</source>
        <translation>Im gemeinsamen Modus wird kein Strom gemessen: Die Stromgrenze von Motor %1 kann nicht wirken.</translation>
    </message>
    <message>
        <source>Motor %1 has unlimited acceleration, so that every 10 ms the speed may jump back up before the limit holds it (inferred). Give it an acceleration; the limit acts on accelerate commands only.</source>
        <translation>Motor %1 hat unbegrenzte Beschleunigung, sodass die Drehzahl alle 10 ms wieder hochspringen kann, bevor die Grenze sie hält (gefolgert). Eine Beschleunigung einstellen; die Grenze wirkt nur bei Beschleunigungsbefehlen.</translation>
    </message>
    <message>
        <source>With gain 0, motor %1 may not be slowed at all when it is over its limit (a guess: the vendor does not state the law).</source>
        <translation>Mit Verstärkung 0 wird Motor %1 bei Überstrom möglicherweise gar nicht verlangsamt (vermutet: der Hersteller gibt das Regelgesetz nicht an).</translation>
    </message>
    <message>
        <source>Another controller on this line has device number %1 already: both would answer at once.</source>
        <translation>Ein anderer Controller an dieser Leitung hat bereits die Gerätenummer %1: Beide würden zugleich antworten.</translation>
    </message>
    <message>
        <source>With polynomial 0x80 every check byte is 0: CRC-7 would find no error at all.</source>
        <translation>Mit Polynom 0x80 ist jedes Prüfbyte 0: CRC-7 würde keinen einzigen Fehler finden.</translation>
    </message>
    <message>
        <source>The lowest bit of polynomial %1 is 0, so that the lowest bit of every check byte is too: CRC-7 finds fewer errors.</source>
        <translation>Das unterste Bit des Polynoms %1 ist 0 und damit auch das unterste Bit jedes Prüfbytes: CRC-7 findet weniger Fehler.</translation>
    </message>
    <message>
        <source>Stored is 0x%1, used is 0x%2: the top bit is always 1 and not stored. With CRC-7, connect with polynomial 0x%2 after the power cycle, or nothing answers.</source>
        <translation>Gespeichert ist 0x%1, verwendet wird 0x%2: Das oberste Bit ist immer 1 und wird nicht gespeichert. Bei CRC-7 nach dem Aus- und Einschalten mit Polynom 0x%2 verbinden, sonst antwortet nichts.</translation>
    </message>
    <message>
        <source>The current reading of motor %1 is one byte and ends at %2 A, within one step of this limit: it probably never exceeds it, and the limit never acts.</source>
        <translation>Der Strommesswert von Motor %1 ist ein Byte und endet bei %2 A, innerhalb eines Schritts dieser Grenze: Er überschreitet sie wahrscheinlich nie, und die Grenze wirkt nie.</translation>
    </message>
</context>
<context>
    <name>Bench</name>
    <message>
        <source>This test has no such result; its name may be mistyped.</source>
        <translation>Diese Prüfung hat kein solches Ergebnis; vielleicht ist der Name vertippt.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Leitung</translation>
    </message>
    <message>
        <source>readings of the currents</source>
        <translation>Messwerte der Ströme</translation>
    </message>
    <message>
        <source>replies lost or damaged</source>
        <translation>verlorene oder beschädigte Antworten</translation>
    </message>
    <message>
        <source>Not passed: ended before its time (%1).</source>
        <translation>Nicht bestanden: vorzeitig beendet (%1).</translation>
    </message>
    <message>
        <source>Not passed: of the expectations, %1 of %2 are not met.</source>
        <translation>Nicht bestanden: %1 von %2 Erwartungen sind nicht erfüllt.</translation>
    </message>
    <message>
        <source>Done. The profile expects nothing of the results.</source>
        <translation>Fertig. Das Profil erwartet nichts von den Ergebnissen.</translation>
    </message>
    <message>
        <source>Passed: every expectation is met (%1).</source>
        <translation>Bestanden: alle Erwartungen sind erfüllt (%1).</translation>
    </message>
    <message>
        <source>Proposals of the bench test &quot;%1&quot;. Look at each before it is written.</source>
        <translation>Vorschläge der Prüfung „%1“. Sehen Sie jeden an, bevor er geschrieben wird.</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht bewertet</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>Motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>Motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>auf Wunsch angehalten</translation>
    </message>
    <message>
        <source>All resistance of the circuit: winding, brushes, wires, bridge.</source>
        <translation>Der ganze Widerstand des Kreises: Wicklung, Bürsten, Leitungen, Brücke.</translation>
    </message>
    <message>
        <source>Needs the supply voltage (supplyVolts in the profile).</source>
        <translation>Braucht die Versorgungsspannung (supplyVolts im Profil).</translation>
    </message>
    <message>
        <source>The current shows no decay after the start: too little inertia for readings every 12 ms, or the motor did not turn.</source>
        <translation>Der Strom klingt nach dem Anlauf nicht ab: zu wenig Trägheit für Messwerte alle 12 ms, oder der Motor drehte sich nicht.</translation>
    </message>
    <message>
        <source>running current</source>
        <translation>Laufstrom</translation>
    </message>
    <message>
        <source>Mean of the last two fifths of %1 runs at speed %2.</source>
        <translation>Mittel der letzten zwei Fünftel von %1 Läufen mit Geschwindigkeit %2.</translation>
    </message>
    <message>
        <source>largest reading</source>
        <translation>größter Messwert</translation>
    </message>
    <message>
        <source>A mean over one reading; the true peak is higher.</source>
        <translation>Ein Mittel über einen Messwert; die wahre Spitze ist höher.</translation>
    </message>
    <message>
        <source>starting current</source>
        <translation>Anlaufstrom</translation>
    </message>
    <message>
        <source>Extrapolated back to the moment of the step.</source>
        <translation>Auf den Augenblick des Sprungs zurückgerechnet.</translation>
    </message>
    <message>
        <source>mechanical time constant</source>
        <translation>mechanische Zeitkonstante</translation>
    </message>
    <message>
        <source>Of the starting current&apos;s decay: inertia × resistance / (motor constant)². The three cannot be told apart without a speed sensor.</source>
        <translation>Aus dem Abklingen des Anlaufstroms: Trägheit × Widerstand / (Motorkonstante)². Die drei lassen sich ohne Drehzahlgeber nicht trennen.</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>braking</source>
        <translation>Bremsen</translation>
    </message>
    <message>
        <source>coasting</source>
        <translation>Auslaufen</translation>
    </message>
    <message>
        <source>Speed left after a pause</source>
        <translation>Restgeschwindigkeit nach einer Pause</translation>
    </message>
    <message>
        <source>pause, ms</source>
        <translation>Pause, ms</translation>
    </message>
    <message>
        <source>speed left, %</source>
        <translation>Restgeschwindigkeit, %</translation>
    </message>
    <message>
        <source>after braking %1 ms</source>
        <translation>nach %1 ms Bremsen</translation>
    </message>
    <message>
        <source>after coasting %1 ms</source>
        <translation>nach %1 ms Auslaufen</translation>
    </message>
    <message>
        <source>speed left</source>
        <translation>Restgeschwindigkeit</translation>
    </message>
    <message>
        <source>From the current of the next start, against a start from rest.</source>
        <translation>Aus dem Strom des nächsten Anlaufs, verglichen mit einem Anlauf aus dem Stand.</translation>
    </message>
    <message>
        <source>braking to a tenth of the speed</source>
        <translation>Bremsen auf ein Zehntel der Geschwindigkeit</translation>
    </message>
    <message>
        <source>coasting to a tenth of the speed</source>
        <translation>Auslaufen auf ein Zehntel der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Interpolated between the pauses that were tried.</source>
        <translation>Zwischen den erprobten Pausen interpoliert.</translation>
    </message>
    <message>
        <source>Longer than the longest pause that was tried (%1 ms).</source>
        <translation>Länger als die längste erprobte Pause (%1 ms).</translation>
    </message>
    <message>
        <source>The current shows no decay after a start from rest, so that nothing tells how fast the motor still turns.</source>
        <translation>Der Strom klingt nach einem Anlauf aus dem Stand nicht ab; nichts sagt also, wie schnell sich der Motor noch dreht.</translation>
    </message>
    <message>
        <source>Of %1 starts from rest.</source>
        <translation>Aus %1 Anläufen aus dem Stand.</translation>
    </message>
    <message>
        <source>motor %1: current × time exceeded %2 A s</source>
        <translation>Motor %1: Strom × Zeit hat %2 A s überschritten</translation>
    </message>
    <message>
        <source>motor %1 drew %2 A, more than %3 A for %4 s</source>
        <translation>Motor %1 zog %2 A, mehr als %3 A für %4 s</translation>
    </message>
    <message>
        <source>it took longer than %1 s</source>
        <translation>es dauerte länger als %1 s</translation>
    </message>
    <message>
        <source>more than %1 replies were lost or damaged on the line</source>
        <translation>mehr als %1 Antworten gingen auf der Leitung verloren oder kamen beschädigt an</translation>
    </message>
    <message>
        <source>Speeds and currents over time</source>
        <translation>Geschwindigkeiten und Ströme über der Zeit</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>A start at once draws about %1 A; with this acceleration (full speed in %2 s) about %3 A, for accelerate commands and the channels.</source>
        <translation>Ein Anlauf auf einmal zieht etwa %1 A; mit dieser Beschleunigung (volle Geschwindigkeit in %2 s) etwa %3 A, bei Beschleunigungsbefehlen und über die Kanäle.</translation>
    </message>
    <message>
        <source>The motor needs %1 A at full speed under the load of this test; half as much again is allowed. A heavier load needs a higher limit.</source>
        <translation>Der Motor braucht bei voller Geschwindigkeit unter der Last dieser Prüfung %1 A; das Anderthalbfache ist zugelassen. Eine größere Last braucht eine höhere Grenze.</translation>
    </message>
    <message>
        <source>coasting takes %1 ms</source>
        <translation>Auslaufen dauert %1 ms</translation>
    </message>
    <message>
        <source>coasting takes longer than was tried</source>
        <translation>Auslaufen dauert länger, als erprobt wurde</translation>
    </message>
    <message>
        <source>To a tenth of its speed within %1 ms: %2, full braking %3 ms.</source>
        <translation>Auf ein Zehntel der Geschwindigkeit in %1 ms: %2, volles Bremsen %3 ms.</translation>
    </message>
    <message>
        <source>en</source>
        <comment>language of the report, as in HTML</comment>
        <translation>de</translation>
    </message>
    <message>
        <source>What such a test can know</source>
        <translation>Was eine solche Prüfung wissen kann</translation>
    </message>
    <message>
        <source>Written by %1 on %2, Qt %3.</source>
        <translation>Geschrieben von %1 unter %2, Qt %3.</translation>
    </message>
    <message>
        <source>Bench test: %1</source>
        <translation>Prüfung: %1</translation>
    </message>
    <message>
        <source>▲ Dry run on the simulated controller and its motors: a prediction. No real motor was moved or measured.</source>
        <translation>▲ Probelauf mit dem simulierten Regler und seinen Motoren: eine Vorhersage. Kein wirklicher Motor wurde bewegt oder gemessen.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Rests on</source>
        <translation>Beruht auf</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Speeds as told: motor 1 solid, motor 2 dashed, the auxiliary motor dotted; braking is drawn as 0. Where readings are missing, the line is broken.</source>
        <translation>Geschwindigkeiten wie befohlen: Motor 1 durchgezogen, Motor 2 gestrichelt, der Hilfsmotor gepunktet; Bremsen ist als 0 gezeichnet. Wo Messwerte fehlen, ist die Linie unterbrochen.</translation>
    </message>
    <message>
        <source>Proposed settings</source>
        <translation>Vorgeschlagene Einstellungen</translation>
    </message>
    <message>
        <source>What follows from the results. Nothing of it was written to the controller.</source>
        <translation>Was aus den Ergebnissen folgt. Nichts davon wurde in den Regler geschrieben.</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Settings of the controller</source>
        <translation>Einstellungen des Reglers</translation>
    </message>
    <message>
        <source>They were not read.</source>
        <translation>Sie wurden nicht gelesen.</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Roh</translation>
    </message>
    <message>
        <source>The test as it was run</source>
        <translation>Die Prüfung, wie sie lief</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>%1 events are left out here</source>
        <translation>%1 Ereignisse sind hier ausgelassen</translation>
    </message>
    <message>
        <source>RC mode</source>
        <translation>RC-Betrieb</translation>
    </message>
    <message>
        <source>analog mode</source>
        <translation>Analogbetrieb</translation>
    </message>
    <message>
        <source>serial mode, RC inputs</source>
        <translation>serieller Betrieb, RC-Eingänge</translation>
    </message>
    <message>
        <source>serial mode, analog inputs</source>
        <translation>serieller Betrieb, Analogeingänge</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Begonnen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>all steps done</source>
        <translation>alle Schritte ausgeführt</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Anschluss</translation>
    </message>
    <message>
        <source>%1 (a simulated controller)</source>
        <translation>%1 (ein simulierter Regler)</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Versorgung</translation>
    </message>
    <message>
        <source>%1 V, as stated</source>
        <translation>%1 V, wie angegeben</translation>
    </message>
    <message>
        <source>Current scale</source>
        <translation>Stromskala</translation>
    </message>
    <message>
        <source>40 mA a step (documented, without a tolerance)</source>
        <translation>40 mA je Stufe (dokumentiert, ohne Toleranz)</translation>
    </message>
    <message>
        <source>150 mA a step (inferred, about ±20 %)</source>
        <translation>150 mA je Stufe (erschlossen, etwa ±20 %)</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>The controller measures only its motor currents, in steps, about 80 times a second, and no speed. Everything beyond currents is reasoned from them by the equations of a brushed motor with dry friction. Uncertainties are about two standard deviations; the tolerance of the current scale itself is not documented and not in them.</source>
        <translation>Der Regler misst nur seine Motorströme, in Stufen, etwa 80-mal in der Sekunde, und keine Drehzahl. Alles über die Ströme hinaus ist aus ihnen mit den Gleichungen eines Bürstenmotors mit trockener Reibung erschlossen. Die Unsicherheiten sind etwa zwei Standardabweichungen; die Toleranz der Stromskala selbst ist nicht dokumentiert und nicht darin enthalten.</translation>
    </message>
    <message>
        <source>All steps done.</source>
        <translation>Alle Schritte ausgeführt.</translation>
    </message>
    <message>
        <source>Ended: %1.</source>
        <translation>Beendet: %1.</translation>
    </message>
    <message>
        <source>limit of a step: %1</source>
        <translation>Grenze eines Schrittes: %1</translation>
    </message>
    <message>
        <source>limit: %1</source>
        <translation>Grenze: %1</translation>
    </message>
    <message>
        <source>serial does not control the motors (mode jumper, channel 5)</source>
        <translation>die serielle Leitung steuert die Motoren nicht (Betriebsart-Jumper, Kanal 5)</translation>
    </message>
    <message>
        <source>motor driver %1 reports a fault</source>
        <translation>Motortreiber %1 meldet einen Fehler</translation>
    </message>
    <message>
        <source>the controller reports motor %1 over its current limit</source>
        <translation>der Regler meldet Motor %1 über seiner Stromgrenze</translation>
    </message>
    <message>
        <source>Motor %1 over the controller&apos;s current limit.</source>
        <translation>Motor %1 über der Stromgrenze des Reglers.</translation>
    </message>
    <message>
        <source>the computer was busy for %1 s</source>
        <translation>der Rechner war %1 s lang beschäftigt</translation>
    </message>
    <message>
        <source>no fresh readings came; no motor was moved</source>
        <translation>es kamen keine frischen Messwerte; kein Motor wurde bewegt</translation>
    </message>
    <message>
        <source>no fresh readings for %1 s</source>
        <translation>keine frischen Messwerte seit %1 s</translation>
    </message>
    <message>
        <source>Started.</source>
        <translation>Begonnen.</translation>
    </message>
    <message>
        <source>what step %1 waited for did not come in %2 s</source>
        <translation>worauf Schritt %1 wartete, kam nicht in %2 s</translation>
    </message>
    <message>
        <source>, round %1 of %2</source>
        <translation>, Runde %1 von %2</translation>
    </message>
    <message>
        <source>speed (of 127)</source>
        <translation>Geschwindigkeit (von 127)</translation>
    </message>
    <message>
        <source>current, A</source>
        <translation>Strom, A</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>reverse</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>The current grows evenly to the end of the ramp: the shaft may not have started. Let the ramp go further.</source>
        <translation>Der Strom wächst bis zum Ende der Rampe gleichmäßig: die Welle lief vielleicht nicht an. Lassen Sie die Rampe weiter gehen.</translation>
    </message>
    <message>
        <source>dead zone, in speed steps of 127</source>
        <translation>tote Zone, in Geschwindigkeitsstufen von 127</translation>
    </message>
    <message>
        <source>Where the current stops growing with the speed; taken as the moment the shaft starts to turn, which no sensor shows.</source>
        <translation>Wo der Strom nicht mehr mit der Geschwindigkeit wächst; gilt als Augenblick, in dem die Welle anläuft, den kein Geber zeigt.</translation>
    </message>
    <message>
        <source>current at the start of motion</source>
        <translation>Strom beim Beginn der Bewegung</translation>
    </message>
    <message>
        <source>Proportional to the friction at rest.</source>
        <translation>Proportional zur Haftreibung.</translation>
    </message>
    <message>
        <source>Current over a slow ramp</source>
        <translation>Strom über einer langsamen Rampe</translation>
    </message>
    <message>
        <source>current held fast at full speed</source>
        <translation>Strom bei voller Geschwindigkeit, festgehalten</translation>
    </message>
    <message>
        <source>Extrapolated from the speeds at which the shaft stands; far beyond what was measured.</source>
        <translation>Hochgerechnet aus den Geschwindigkeiten, bei denen die Welle steht; weit über das Gemessene hinaus.</translation>
    </message>
    <message>
        <source>Current over speed</source>
        <translation>Strom über der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Needs three speeds or more, of at least 16, in a direction.</source>
        <translation>Braucht mindestens drei Geschwindigkeiten von 16 oder mehr in einer Richtung.</translation>
    </message>
    <message>
        <source>current that friction takes</source>
        <translation>Strom für die Reibung</translation>
    </message>
    <message>
        <source>The straight line through the settled currents, at speed 0.</source>
        <translation>Die Gerade durch die eingeschwungenen Ströme, bei Geschwindigkeit 0.</translation>
    </message>
    <message>
        <source>current at full speed</source>
        <translation>Strom bei voller Geschwindigkeit</translation>
    </message>
    <message>
        <source>The same line, at speed 127.</source>
        <translation>Dieselbe Gerade, bei Geschwindigkeit 127.</translation>
    </message>
    <message>
        <source>forward less reverse</source>
        <translation>vorwärts weniger rückwärts</translation>
    </message>
    <message>
        <source>Mean over all speeds.</source>
        <translation>Mittel über alle Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>Needs both directions.</source>
        <translation>Braucht beide Richtungen.</translation>
    </message>
    <message>
        <source>Left against right</source>
        <translation>Links gegen rechts</translation>
    </message>
    <message>
        <source>Needs both motors at the same speeds at the same time.</source>
        <translation>Braucht beide Motoren zur selben Zeit mit denselben Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>Motor 1 less motor 2, mean of %1 speeds.</source>
        <translation>Motor 1 weniger Motor 2, Mittel von %1 Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>difference of the currents</source>
        <translation>Unterschied der Ströme</translation>
    </message>
    <message>
        <source>largest difference</source>
        <translation>größter Unterschied</translation>
    </message>
    <message>
        <source>At the speed where they differ most.</source>
        <translation>Bei der Geschwindigkeit mit dem größten Unterschied.</translation>
    </message>
    <message>
        <source>motor 1 in parts of motor 2</source>
        <translation>Motor 1 in Teilen von Motor 2</translation>
    </message>
    <message>
        <source>More current at the same speed: more friction or load.</source>
        <translation>Mehr Strom bei gleicher Geschwindigkeit: mehr Reibung oder Last.</translation>
    </message>
    <message>
        <source>mean current while driven</source>
        <translation>mittlerer Strom im Betrieb</translation>
    </message>
    <message>
        <source>Mean of the means at each speed.</source>
        <translation>Mittel der Mittel bei jeder Geschwindigkeit.</translation>
    </message>
    <message>
        <source>charge</source>
        <translation>Ladung</translation>
    </message>
    <message>
        <source>drift of the running current</source>
        <translation>Drift des Laufstroms</translation>
    </message>
    <message>
        <source>Last quarter of the test less the first; warming, running in and wear all show here.</source>
        <translation>Letztes Viertel der Prüfung weniger das erste; Erwärmung, Einlaufen und Verschleiß zeigen sich hier.</translation>
    </message>
    <message>
        <source>Needs runs in the first and in the last quarter of the test.</source>
        <translation>Braucht Läufe im ersten und im letzten Viertel der Prüfung.</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>the motion limits (highest speed, soft start, soft stop) would change the orders of this test; choose a slower test or lift them</source>
        <translation>die Bewegungsgrenzen (höchste Geschwindigkeit, sanfter Anlauf, sanfter Auslauf) würden die Befehle dieser Prüfung ändern; wählen Sie eine langsamere Prüfung oder heben Sie die Grenzen auf</translation>
    </message>
    <message>
        <source>the connection was lost</source>
        <translation>die Verbindung ging verloren</translation>
    </message>
    <message>
        <source>step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>the auxiliary motor cannot brake</source>
        <translation>der Hilfsmotor kann nicht bremsen</translation>
    </message>
    <message>
        <source>the auxiliary motor has no reverse</source>
        <translation>der Hilfsmotor hat keinen Rückwärtsgang</translation>
    </message>
    <message>
        <source>it asks for more than full speed (127)</source>
        <translation>er verlangt mehr als volle Geschwindigkeit (127)</translation>
    </message>
    <message>
        <source>there is nothing to repeat</source>
        <translation>es gibt nichts zu wiederholen</translation>
    </message>
    <message>
        <source>repetitions stand in each other at most three deep</source>
        <translation>Wiederholungen stehen höchstens dreifach ineinander</translation>
    </message>
    <message>
        <source>what is repeated takes no time; add a hold</source>
        <translation>was wiederholt wird, dauert nicht; fügen Sie ein Halten ein</translation>
    </message>
    <message>
        <source>the profile has no steps</source>
        <translation>das Profil hat keine Schritte</translation>
    </message>
    <message>
        <source>the profile takes longer than a day, which is the most</source>
        <translation>das Profil dauert länger als einen Tag, das ist das Höchste</translation>
    </message>
    <message>
        <source>it is no ordinary file</source>
        <translation>es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>is longer than 4000 characters</source>
        <translation>ist länger als 4000 Zeichen</translation>
    </message>
    <message>
        <source>is missing; give %1</source>
        <translation>fehlt; geben Sie %1 an</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>%1 is not known; give %2</source>
        <translation>%1 ist nicht bekannt; geben Sie %2 an</translation>
    </message>
    <message>
        <source>is not known; is %1 meant?</source>
        <translation>ist nicht bekannt; ist %1 gemeint?</translation>
    </message>
    <message>
        <source>is not known here, and no comment, which would be a text</source>
        <translation>ist hier nicht bekannt, und kein Kommentar, der ein Text wäre</translation>
    </message>
    <message>
        <source>line %1, %2: stands twice</source>
        <translation>Zeile %1, %2: steht zweimal da</translation>
    </message>
    <message>
        <source>must be &quot;trexpanel-bench-profile&quot;: this is no bench test</source>
        <translation>muss „trexpanel-bench-profile“ sein: dies ist keine Prüfung</translation>
    </message>
    <message>
        <source>%1 is newer than this program</source>
        <translation>%1 ist neuer als dieses Programm</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>says how long, but amperes is missing</source>
        <translation>sagt, wie lange, aber amperes fehlt</translation>
    </message>
    <message>
        <source>needs minimum, maximum or both</source>
        <translation>braucht minimum, maximum oder beide</translation>
    </message>
    <message>
        <source>is above maximum</source>
        <translation>liegt über maximum</translation>
    </message>
    <message>
        <source>larger than 256 KiB, which no bench test is</source>
        <translation>größer als 256 KiB, das ist keine Prüfung</translation>
    </message>
    <message>
        <source>a list of steps</source>
        <translation>eine Liste von Schritten</translation>
    </message>
    <message>
        <source>has more than 2000 steps; use repeat</source>
        <translation>hat mehr als 2000 Schritte; verwenden Sie repeat</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>the current of the auxiliary motor is not measured</source>
        <translation>der Strom des Hilfsmotors wird nicht gemessen</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>Sprungantwort</translation>
    </message>
    <message>
        <source>Eight starts at once to speed 80, half of them in reverse. The decay of the starting current gives the mechanical time constant. Let the shafts turn freely.</source>
        <translation>Acht Anläufe auf einmal bis Geschwindigkeit 80, die Hälfte rückwärts. Das Abklingen des Anlaufstroms gibt die mechanische Zeitkonstante. Lassen Sie die Wellen frei drehen.</translation>
    </message>
    <message>
        <source>Slow ramp</source>
        <translation>Langsame Rampe</translation>
    </message>
    <message>
        <source>One speed step a second up to 40, forward and then in reverse. The knee of the current shows where the shaft starts to turn: the dead zone and the friction at rest.</source>
        <translation>Jede Sekunde eine Geschwindigkeitsstufe bis 40, vorwärts und dann rückwärts. Der Knick des Stroms zeigt, wo die Welle anläuft: die tote Zone und die Haftreibung.</translation>
    </message>
    <message>
        <source>Current against speed</source>
        <translation>Strom gegen Geschwindigkeit</translation>
    </message>
    <message>
        <source>Five speeds up to full speed, two seconds each, forward and in reverse. Shows what friction takes and what the motor draws at full speed under the load that it has now.</source>
        <translation>Fünf Geschwindigkeiten bis zur vollen, je zwei Sekunden, vorwärts und rückwärts. Zeigt, was die Reibung nimmt und was der Motor bei voller Geschwindigkeit unter seiner jetzigen Last zieht.</translation>
    </message>
    <message>
        <source>Both motors at the same three speeds at the same time, forward and in reverse. Different currents mean different friction or load on the two sides.</source>
        <translation>Beide Motoren zur selben Zeit mit denselben drei Geschwindigkeiten, vorwärts und rückwärts. Verschiedene Ströme bedeuten verschiedene Reibung oder Last auf den zwei Seiten.</translation>
    </message>
    <message>
        <source>Braking</source>
        <translation>Bremsen</translation>
    </message>
    <message>
        <source>Runs at speed 100, pauses of several lengths with the brake and without, and starts again. The current of each new start tells how much of the speed was left.</source>
        <translation>Läufe mit Geschwindigkeit 100, verschieden lange Pausen mit und ohne Bremse, und neue Anläufe. Der Strom jedes neuen Anlaufs sagt, wie viel Geschwindigkeit noch übrig war.</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Dauerlauf</translation>
    </message>
    <message>
        <source>A quarter of an hour to and fro at speed 70. The drift of the running current shows warming, running in and wear; raise the number of rounds for a longer test.</source>
        <translation>Eine Viertelstunde hin und her mit Geschwindigkeit 70. Die Drift des Laufstroms zeigt Erwärmung, Einlaufen und Verschleiß; erhöhen Sie die Zahl der Runden für eine längere Prüfung.</translation>
    </message>
    <message>
        <source>the controller did not answer %1 times in a row; it may have been restarted</source>
        <translation>der Controller hat %1-mal hintereinander nicht geantwortet; vielleicht wurde er neu gestartet</translation>
    </message>
</context>
<context>
    <name>BenchPdf</name>
    <message>
        <source>▲ Dry run on the simulated controller and its motors: a prediction. No real motor was moved or measured.</source>
        <translation>▲ Probelauf mit dem simulierten Regler und seinen Motoren: eine Vorhersage. Kein wirklicher Motor wurde bewegt oder gemessen.</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>The test as it was run</source>
        <translation>Die Prüfung, wie sie lief</translation>
    </message>
    <message>
        <source>What such a test can know</source>
        <translation>Was eine solche Prüfung wissen kann</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Rests on</source>
        <translation>Beruht auf</translation>
    </message>
    <message>
        <source>Proposed settings</source>
        <translation>Vorgeschlagene Einstellungen</translation>
    </message>
    <message>
        <source>What follows from the results. Nothing of it was written to the controller.</source>
        <translation>Was aus den Ergebnissen folgt. Nichts davon wurde in den Regler geschrieben.</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Settings of the controller</source>
        <translation>Einstellungen des Reglers</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Roh</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Bench test: %1</source>
        <translation>Prüfung: %1</translation>
    </message>
</context>
<context>
    <name>BenchSteps</name>
    <message>
        <source>until the current is above %1 A</source>
        <translation>bis der Strom über %1 A liegt</translation>
    </message>
    <message>
        <source>until the current is below %1 A</source>
        <translation>bis der Strom unter %1 A liegt</translation>
    </message>
    <message>
        <source>until the status shows %1</source>
        <translation>bis der Status %1 zeigt</translation>
    </message>
    <message>
        <source>until channel %1 is above %2</source>
        <translation>bis Kanal %1 über %2 liegt</translation>
    </message>
    <message>
        <source>until channel %1 is below %2</source>
        <translation>bis Kanal %1 unter %2 liegt</translation>
    </message>
    <message>
        <source>until %1 s since the start</source>
        <translation>bis %1 s seit dem Beginn</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Accelerate</source>
        <translation>Beschleunigen</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Step and back</source>
        <translation>Sprung und zurück</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Brake</source>
        <translation>Bremsen</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Warten</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>Motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Aux</source>
        <translation>Hilfsmotor</translation>
    </message>
    <message>
        <source>Current above</source>
        <translation>Strom über</translation>
    </message>
    <message>
        <source>Current below</source>
        <translation>Strom unter</translation>
    </message>
    <message>
        <source>Status bit</source>
        <translation>Statusbit</translation>
    </message>
    <message>
        <source>Channel above</source>
        <translation>Kanal über</translation>
    </message>
    <message>
        <source>Channel below</source>
        <translation>Kanal unter</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>Zeit seit Beginn</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 auf %2</translation>
    </message>
    <message>
        <source>%1 ± %2, every %3 s</source>
        <translation>%1 ± %2, alle %3 s</translation>
    </message>
    <message>
        <source>duty %1</source>
        <translation>Tastgrad %1</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
</context>
<context>
    <name>Calibration</name>
    <message>
        <source>No valid reading came. Check the plug, the receiver and its power, or leave this channel out.</source>
        <translation>Es kam kein gültiger Messwert. Stecker, Empfänger und dessen Versorgung prüfen oder diesen Kanal auslassen.</translation>
    </message>
    <message>
        <source>It was never still. Let go of it; if it jitters by itself, look at its potentiometer or cable.</source>
        <translation>Nie in Ruhe. Loslassen; zittert der Wert von selbst, Potentiometer oder Kabel prüfen.</translation>
    </message>
    <message>
        <source>%4 % of the pulses were missing. Check the receiver, its antenna and the plug.</source>
        <translation>%4 % der Impulse fehlten. Empfänger, dessen Antenne und Stecker prüfen.</translation>
    </message>
    <message>
        <source>It did not move. Move it to both ends, or leave this channel out.</source>
        <translation>Keine Bewegung. In beide Endlagen bewegen oder diesen Kanal auslassen.</translation>
    </message>
    <message>
        <source>It moved %1 at most, and %2 to each side are needed. Move it further, or widen the travel in the transmitter.</source>
        <translation>Höchstens um %1 bewegt; nötig sind %2 nach jeder Seite. Weiter bewegen oder den Weg im Sender vergrößern.</translation>
    </message>
    <message>
        <source>It was moved one way only. Move it to both ends.</source>
        <translation>Nur in eine Richtung bewegt. In beide Endlagen bewegen.</translation>
    </message>
    <message>
        <source>It is too noisy (%3). Look at its potentiometer, cable or receiver.</source>
        <translation>Zu starkes Rauschen (%3). Potentiometer, Kabel oder Empfänger prüfen.</translation>
    </message>
    <message>
        <source>It rests at one end, as levers and switches do; the other end is set equally far away.</source>
        <translation>Ruht in einer Endlage, wie es Hebel und Schalter tun; die andere Endlage wird gleich weit entfernt gesetzt.</translation>
    </message>
    <message>
        <source>%4 % of the pulses were missing.</source>
        <translation>%4 % der Impulse fehlten.</translation>
    </message>
    <message>
        <source>It is somewhat noisy (%3); the deadband is wider for it.</source>
        <translation>Etwas Rauschen (%3); das Totband ist deshalb breiter.</translation>
    </message>
    <message>
        <source>One side moves much less than the other, so that its control is coarser.</source>
        <translation>Eine Seite hat viel weniger Weg als die andere und steuert deshalb gröber.</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 V</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>brauchbar</translation>
    </message>
    <message>
        <source>do again</source>
        <translation>wiederholen</translation>
    </message>
    <message>
        <source>Quiet at rest, full travel both ways.</source>
        <translation>Ruhig in Neutral, voller Weg nach beiden Seiten.</translation>
    </message>
    <message>
        <source>Samples: %1, missed: %2 (%3 %)</source>
        <translation>Messwerte: %1, fehlend: %2 (%3 %)</translation>
    </message>
    <message>
        <source>Travel: %1 down, %2 up; symmetry %3 %</source>
        <translation>Weg: %1 nach unten, %2 nach oben; Symmetrie %3 %</translation>
    </message>
    <message>
        <source>Ends pulled in by %1 and %2, so that the full stick gives 127</source>
        <translation>Endlagen um %1 und %2 eingerückt, damit voller Ausschlag 127 ergibt</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>left as it is</source>
        <translation>bleibt so</translation>
    </message>
    <message>
        <source>still</source>
        <translation>ruhig</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>bewegt</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>%1 s more</source>
        <translation>noch %1 s</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>hold on</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>in Bewegung</translation>
    </message>
    <message>
        <source>already so</source>
        <translation>schon so</translation>
    </message>
    <message>
        <source>writing…</source>
        <translation>schreibt…</translation>
    </message>
    <message>
        <source>written</source>
        <translation>geschrieben</translation>
    </message>
    <message>
        <source>Read back as written.</source>
        <translation>Zurückgelesen wie geschrieben.</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>nächster Wert</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>misslungen</translation>
    </message>
    <message>
        <source>as before</source>
        <translation>wie zuvor</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Neutral</source>
        <translation>Neutral</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Endlagen</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Choose the channels to calibrate, switch the transmitter on, then start.</source>
        <translation>Zu kalibrierende Kanäle wählen, Sender einschalten, dann starten.</translation>
    </message>
    <message>
        <source>The neutrals are found. Go on.</source>
        <translation>Neutralstellungen gefunden. Weiter.</translation>
    </message>
    <message>
        <source>Let go of all sticks and levers, and hold still.</source>
        <translation>Alle Knüppel und Hebel loslassen und nichts bewegen.</translation>
    </message>
    <message>
        <source>All ends are found. Go on, or move further.</source>
        <translation>Alle Endlagen gefunden. Weiter, oder noch mehr ausschlagen.</translation>
    </message>
    <message>
        <source>Move every stick, lever and switch slowly to both ends, and hold it there for a moment.</source>
        <translation>Jeden Knüppel, Hebel und Schalter langsam in beide Endlagen bewegen und dort einen Moment halten.</translation>
    </message>
    <message>
        <source>Compare the new numbers with those of before. Nothing has been written yet.</source>
        <translation>Die neuen Zahlen mit den bisherigen vergleichen. Noch ist nichts geschrieben.</translation>
    </message>
    <message>
        <source>Writing, and reading back what was written…</source>
        <translation>Schreiben und Zurücklesen des Geschriebenen…</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>RC</source>
        <translation>RC</translation>
    </message>
    <message>
        <source>analog</source>
        <translation>Analog</translation>
    </message>
    <message>
        <source>%1 mode: the sticks move the motors, and nothing can be written. Better use serial mode: power off, mode jumper off, power on.</source>
        <translation>%1-Modus: die Knüppel bewegen die Motoren, und nichts kann geschrieben werden. Besser den seriellen Modus verwenden: ausschalten, Modus-Steckbrücke abziehen, einschalten.</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>no readings</source>
        <translation>keine Werte</translation>
    </message>
    <message>
        <source>no pulse</source>
        <translation>kein Impuls</translation>
    </message>
    <message>
        <source>no reading</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>RC and analog seem to be mixed up. %5</source>
        <translation>RC und Analog scheinen verwechselt zu sein. %5</translation>
    </message>
    <message>
        <source>%6 % of its readings jump far beyond its noise, as a failing potentiometer or a loose cable does. Repair that first.</source>
        <translation>%6 % der Messwerte springen weit über das Rauschen hinaus, wie bei einem defekten Potentiometer oder losen Kabel. Dies zuerst beheben.</translation>
    </message>
    <message>
        <source>It comes to rest up to %7 away from its neutral, too far for a deadband to cover. Look at its spring and its mechanics.</source>
        <translation>Kommt bis zu %7 neben Neutral zur Ruhe, zu weit, um vom Totband abgedeckt zu werden. Feder und Mechanik prüfen.</translation>
    </message>
    <message>
        <source>Channel %8 moved when this one was asked for: they seem to be swapped. Exchange their plugs, or their axes in the transmitter.</source>
        <translation>Kanal %8 bewegte sich, als dieser gefragt war: Sie scheinen vertauscht zu sein. Ihre Stecker tauschen oder ihre Achsen im Sender.</translation>
    </message>
    <message>
        <source>It rests on its low side, where it is thought to be on (below half-way; a guess, the threshold is not published). Learn it with the switch in the other position, or reverse it in the transmitter.</source>
        <translation>Ruht auf der niedrigen Seite, wo er vermutlich eingeschaltet ist (unter der Mitte; vermutet, die Schwelle ist nicht veröffentlicht). Mit dem Schalter in der anderen Stellung lernen oder im Sender umkehren.</translation>
    </message>
    <message>
        <source>%6 % of its readings jump beyond its noise; they were left out. Its potentiometer or cable may be wearing out.</source>
        <translation>%6 % der Messwerte springen über das Rauschen hinaus; sie wurden ausgelassen. Potentiometer oder Kabel könnten verschlissen sein.</translation>
    </message>
    <message>
        <source>It comes to rest up to %7 away from its neutral; the deadband covers that.</source>
        <translation>Kommt bis zu %7 neben Neutral zur Ruhe; das Totband deckt das ab.</translation>
    </message>
    <message>
        <source>Its travel has fewer counts than the 127 steps to each side, so that some speeds cannot be chosen.</source>
        <translation>Der Weg hat weniger Stufen als die 127 Schritte nach jeder Seite, sodass manche Drehzahlen nicht wählbar sind.</translation>
    </message>
    <message>
        <source>An end lies at the limit of what can be read; part of the travel may be cut off. Shorten the travel in the transmitter.</source>
        <translation>Eine Endlage liegt an der Grenze des Lesbaren; ein Teil des Wegs kann abgeschnitten sein. Den Weg im Sender verkleinern.</translation>
    </message>
    <message>
        <source>It was to be read as RC pulses, but most readings are such as only a voltage gives.</source>
        <translation>RC-Impulse sollten gelesen werden, aber die meisten Messwerte sind solche, wie sie nur eine Spannung ergibt.</translation>
    </message>
    <message>
        <source>It was to be read as a voltage, but most readings are such as only RC pulses give.</source>
        <translation>Eine Spannung sollte gelesen werden, aber die meisten Messwerte sind solche, wie sie nur RC-Impulse ergeben.</translation>
    </message>
    <message>
        <source>At rest it reads 0 V most of the time, with short bursts, as an RC receiver on an analog input would (a guess).</source>
        <translation>In Ruhe meist 0 V mit kurzen Impulsen, wie von einem RC-Empfänger an einem Analogeingang (vermutet).</translation>
    </message>
    <message>
        <source>It wandered for seconds without ever resting, as an analog input with nothing, or an RC receiver, on it would (a guess).</source>
        <translation>Wanderte sekundenlang, ohne je zu ruhen, wie ein Analogeingang, an dem nichts oder ein RC-Empfänger angeschlossen ist (vermutet).</translation>
    </message>
    <message>
        <source>Quiet at rest, full travel both ways, comes back to its neutral.</source>
        <translation>Ruhig in Neutral, voller Weg nach beiden Seiten, kehrt nach Neutral zurück.</translation>
    </message>
    <message>
        <source>Deadband: ±%1 (%2 σ of its noise)</source>
        <translation>Totband: ±%1 (%2 σ des Rauschens)</translation>
    </message>
    <message>
        <source>Deadband: ±%1 (%2 × its farthest rest and %3 σ of its noise)</source>
        <translation>Totband: ±%1 (%2 × die fernste Ruhelage und %3 σ des Rauschens)</translation>
    </message>
    <message>
        <source>Deadband: ±%1 (the least; %2 σ of its noise are ±%3)</source>
        <translation>Totband: ±%1 (Mindestwert; %2 σ des Rauschens sind ±%3)</translation>
    </message>
    <message>
        <source>Centring: not tried</source>
        <translation>Rückkehr: nicht erprobt</translation>
    </message>
    <message>
        <source>Centring: %1 returns, rests within %2, up to %3 off neutral</source>
        <translation>Rückkehr: %1-mal, Ruhelagen innerhalb von %2, bis zu %3 neben Neutral</translation>
    </message>
    <message>
        <source>%1; from above and below %2 apart</source>
        <translation>%1; von oben und von unten %2 auseinander</translation>
    </message>
    <message>
        <source>Noise at rest: σ %1 (%2 % of the travel); jumps: %3</source>
        <translation>Rauschen in Ruhe: σ %1 (%2 % des Wegs); Sprünge: %3</translation>
    </message>
    <message>
        <source>Switches on at and below about %1 (a guess: the threshold is not published)</source>
        <translation>Schaltet bei etwa %1 und darunter ein (vermutet: die Schwelle ist nicht veröffentlicht)</translation>
    </message>
    <message>
        <source>Look at the directions and switches. Go on.</source>
        <translation>Richtungen und Schalter ansehen. Weiter.</translation>
    </message>
    <message>
        <source>Push channel %1 forward, and hold it.</source>
        <translation>Kanal %1 nach vorn drücken und halten.</translation>
    </message>
    <message>
        <source>Channel %1 is next: let go of all sticks first.</source>
        <translation>Als Nächstes Kanal %1: zuerst alle Knüppel loslassen.</translation>
    </message>
    <message>
        <source>The RC calibration is set; the analog one stays.</source>
        <translation>Die RC-Kalibrierung wird gesetzt; die analoge bleibt.</translation>
    </message>
    <message>
        <source>The analog calibration is set; the RC one stays.</source>
        <translation>Die analoge Kalibrierung wird gesetzt; die RC-Kalibrierung bleibt.</translation>
    </message>
    <message>
        <source>Serial mode: the sticks do not move the motors.</source>
        <translation>Serieller Modus: Die Knüppel bewegen die Motoren nicht.</translation>
    </message>
    <message>
        <source>how the sticks come back</source>
        <translation>wie die Knüppel zurückkehren</translation>
    </message>
    <message>
        <source>which way is forward</source>
        <translation>welche Richtung vorwärts ist</translation>
    </message>
    <message>
        <source>trying the new numbers</source>
        <translation>Erproben der neuen Zahlen</translation>
    </message>
    <message>
        <source>This controller reads the bytes of a calibration as 8 bits each and cannot hold the learned numbers: shown are the nearest that it can.</source>
        <translation>Dieser Controller liest die Bytes einer Kalibrierung als je 8 Bit und kann die gelernten Zahlen nicht aufnehmen: Gezeigt sind die nächstliegenden, die er aufnehmen kann.</translation>
    </message>
    <message>
        <source>Skipped, so less certain: %1.</source>
        <translation>Übersprungen, daher weniger sicher: %1.</translation>
    </message>
    <message>
        <source>Returns</source>
        <translation>Rückkehr</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>It is known how the sticks come back. Go on.</source>
        <translation>Die Rückkehr der Knüppel ist bekannt. Weiter.</translation>
    </message>
    <message>
        <source>Move every stick and let it go, twice, best to both sides.</source>
        <translation>Jeden Knüppel zweimal bewegen und loslassen, am besten nach beiden Seiten.</translation>
    </message>
    <message>
        <source>The new numbers do what they should. Go on.</source>
        <translation>Die neuen Zahlen bewirken, was sie sollen. Weiter.</translation>
    </message>
    <message>
        <source>Try the new numbers: move every stick to both ends, then let it go. Nothing has been written yet.</source>
        <translation>Die neuen Zahlen erproben: jeden Knüppel in beide Endlagen bewegen, dann loslassen. Noch ist nichts geschrieben.</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>by %1: the countdown starts again</source>
        <translation>um %1: Countdown beginnt neu</translation>
    </message>
    <message>
        <source>comes back within %1</source>
        <translation>kehrt auf %1 genau zurück</translation>
    </message>
    <message>
        <source>levers and switches need not</source>
        <translation>bei Hebeln und Schaltern nicht nötig</translation>
    </message>
    <message>
        <source>let it go</source>
        <translation>loslassen</translation>
    </message>
    <message>
        <source>coming back</source>
        <translation>kehrt zurück</translation>
    </message>
    <message>
        <source>%1, need %2</source>
        <translation>%1, nötig %2</translation>
    </message>
    <message>
        <source>no threshold</source>
        <translation>keine Schwelle</translation>
    </message>
    <message>
        <source>≈: how these channels switch is not published; this is a guess.</source>
        <translation>≈: Wie diese Kanäle schalten, ist nicht veröffentlicht; dies ist vermutet.</translation>
    </message>
    <message>
        <source>≈ serial override on</source>
        <translation>≈ serielle Übernahme ein</translation>
    </message>
    <message>
        <source>≈ flip on</source>
        <translation>≈ Überkopf ein</translation>
    </message>
    <message>
        <source>≈ on at %1 and below</source>
        <translation>≈ ein bei %1 und darunter</translation>
    </message>
    <message>
        <source>≈ off</source>
        <translation>≈ aus</translation>
    </message>
    <message>
        <source>push forward</source>
        <translation>nach vorn drücken</translation>
    </message>
    <message>
        <source>channel %1 moved</source>
        <translation>Kanal %1 bewegte sich</translation>
    </message>
    <message>
        <source>Channels %1 and %2 are swapped: exchange their plugs, or choose the other stick in the transmitter.</source>
        <translation>Kanäle %1 und %2 sind vertauscht: ihre Stecker tauschen oder im Sender den anderen Knüppel wählen.</translation>
    </message>
    <message>
        <source>runs backwards</source>
        <translation>läuft rückwärts</translation>
    </message>
    <message>
        <source>Its readings fall when it is pushed forward.</source>
        <translation>Die Messwerte fallen beim Drücken nach vorn.</translation>
    </message>
    <message>
        <source>runs forward</source>
        <translation>läuft vorwärts</translation>
    </message>
    <message>
        <source>Its readings rise when it is pushed forward.</source>
        <translation>Die Messwerte steigen beim Drücken nach vorn.</translation>
    </message>
    <message>
        <source>%1 → %2 new</source>
        <translation>%1 → %2 neu</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>bestätigt</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>bewegen</translation>
    </message>
    <message>
        <source>%1 samples, %2 % missed, σ %3, symmetry %4 %</source>
        <translation>%1 Messwerte, %2 % fehlend, σ %3, Symmetrie %4 %</translation>
    </message>
    <message>
        <source>The nearest values that this controller can take, read back; the deadband covers the difference at neutral.</source>
        <translation>Die nächstliegenden Werte, die dieser Controller annehmen kann, zurückgelesen; das Totband deckt den Unterschied bei Neutral ab.</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>Keeps its old values.</source>
        <translation>Behält seine alten Werte.</translation>
    </message>
    <message>
        <source>Old or new values: it is read when the controller is there again.</source>
        <translation>Alte oder neue Werte: Es wird gelesen, sobald der Controller wieder da ist.</translation>
    </message>
    <message>
        <source>new values</source>
        <translation>neue Werte</translation>
    </message>
    <message>
        <source>Read back.</source>
        <translation>Zurückgelesen.</translation>
    </message>
    <message>
        <source>old values</source>
        <translation>alte Werte</translation>
    </message>
    <message>
        <source>other values</source>
        <translation>andere Werte</translation>
    </message>
    <message>
        <source>Neither the old nor the new ones.</source>
        <translation>Weder die alten noch die neuen.</translation>
    </message>
    <message>
        <source>Put back, and read back.</source>
        <translation>Wiederhergestellt und zurückgelesen.</translation>
    </message>
    <message>
        <source>The nearest to its former values that this controller can take.</source>
        <translation>So nah an den früheren Werten, wie es dieser Controller zulässt.</translation>
    </message>
    <message>
        <source>down %1
up %2</source>
        <translation>unten %1
oben %2</translation>
    </message>
    <message>
        <source>ends %1 / %2</source>
        <translation>Enden %1 / %2</translation>
    </message>
    <message>
        <source>, before %1 / %2</source>
        <translation>, vorher %1 / %2</translation>
    </message>
    <message>
        <source>It was not held at its ends for long enough to know them. Hold it at each end for a second.</source>
        <translation>Er wurde an seinen Enden nicht lange genug gehalten, um sie zu kennen. Halten Sie ihn an jedem Ende eine Sekunde lang.</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>±%1 (%2 samples)</source>
        <translation>±%1 (%2 Messwerte)</translation>
    </message>
    <message>
        <source>Ends known within: low %1, high %2</source>
        <translation>Enden bekannt auf: unten %1, oben %2</translation>
    </message>
    <message>
        <source>hold longer</source>
        <translation>länger halten</translation>
    </message>
    <message>
        <source>, was %1</source>
        <translation>, vorher %1</translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Neutral</source>
        <translation>Neutral</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Deadband</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>Learned</source>
        <translation>Gelernt</translation>
    </message>
    <message>
        <source>Control of Pololu TReX Jr and TReX motor controllers.</source>
        <translation>Steuerung der Motorcontroller Pololu TReX Jr und TReX.</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>this help; after a command, its help</source>
        <translation>diese Hilfe; nach einem Befehl dessen Hilfe</translation>
    </message>
    <message>
        <source>JSON on stdout instead of text</source>
        <translation>JSON statt Text auf stdout</translation>
    </message>
    <message>
        <source>log transactions to stderr; -vv the bytes, too</source>
        <translation>Transaktionen auf stderr protokollieren; -vv auch die Bytes</translation>
    </message>
    <message>
        <source>Options go before the command. Numbers may be decimal or 0x hex.
Exit: 0 done, 1 refused, 2 usage, 3 no reply, 4 port, 5 read-back differs, 130 interrupted.</source>
        <translation>Optionen stehen vor dem Befehl. Zahlen dezimal oder hexadezimal mit 0x.
Ende: 0 fertig, 1 abgelehnt, 2 Aufruf falsch, 3 keine Antwort, 4 Port, 5 Zurückgelesenes weicht ab, 130 unterbrochen.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>There is no command &apos;%1&apos;</source>
        <translation>Es gibt keinen Befehl &apos;%1&apos;</translation>
    </message>
    <message>
        <source>No command given</source>
        <translation>Kein Befehl angegeben</translation>
    </message>
    <message>
        <source>%1; nothing was sent. See: trexctl%2 --help</source>
        <translation>%1; nichts wurde gesendet. Siehe: trexctl%2 --help</translation>
    </message>
    <message>
        <source>RC mode</source>
        <translation>RC-Modus</translation>
    </message>
    <message>
        <source>analog mode</source>
        <translation>Analogmodus</translation>
    </message>
    <message>
        <source>serial mode, RC inputs</source>
        <translation>serieller Modus, RC-Eingänge</translation>
    </message>
    <message>
        <source>serial mode, analog inputs</source>
        <translation>serieller Modus, Analogeingänge</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>about %1 A</source>
        <translation>etwa %1 A</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no value for %2 (%3). Nothing was sent; see: trexctl param list</source>
        <translation>&apos;%1&apos; ist kein Wert für %2 (%3). Nichts wurde gesendet; siehe: trexctl param list</translation>
    </message>
    <message>
        <source>There is no parameter &apos;%1&apos;. Nothing was sent; trexctl param list shows all.</source>
        <translation>Es gibt keinen Parameter &apos;%1&apos;. Nichts wurde gesendet; trexctl param list zeigt alle.</translation>
    </message>
    <message>
        <source>%1 is no value to read or write. Nothing was sent; its command is: trexctl param reset --yes</source>
        <translation>%1 ist kein Wert zum Lesen oder Schreiben. Nichts wurde gesendet; der Befehl dafür: trexctl param reset --yes</translation>
    </message>
    <message>
        <source>the answer to standard output</source>
        <translation>die Antwort auf die Standardausgabe</translation>
    </message>
    <message>
        <source>a stream until SIGINT (Ctrl+C) or --duration</source>
        <translation>fortlaufend bis SIGINT (Strg+C) oder --duration</translation>
    </message>
    <message>
        <source>samples a second, default 20; implies --watch</source>
        <translation>Messwerte je Sekunde, Standard 20; schließt --watch ein</translation>
    </message>
    <message>
        <source>seconds to watch; implies --watch</source>
        <translation>Dauer in Sekunden; schließt --watch ein</translation>
    </message>
    <message>
        <source>%1 samples failed and are left out.</source>
        <translation>%1 Messwerte sind ausgefallen und fehlen.</translation>
    </message>
    <message>
        <source>[y/N]</source>
        <translation>[ja/N]</translation>
    </message>
    <message>
        <source>channel 1 to 5; default: all</source>
        <translation>Kanal 1 bis 5; Standard: alle</translation>
    </message>
    <message>
        <source>channel 1 to 5</source>
        <translation>Kanal 1 bis 5</translation>
    </message>
    <message>
        <source>raw: 0.4 µs or 10-bit counts, by the input set in force</source>
        <translation>Rohwert: 0.4 µs oder 10-Bit-Stufen, je nach geltenden Eingängen</translation>
    </message>
    <message>
        <source>MIN to MAX</source>
        <translation>MIN bis MAX</translation>
    </message>
    <message>
        <source>above MIN, at most 16383</source>
        <translation>über MIN, höchstens 16383</translation>
    </message>
    <message>
        <source>on both sides of neutral</source>
        <translation>zu beiden Seiten von Neutral</translation>
    </message>
    <message>
        <source>This controller joins calibration bytes as low + 256 × high: the nearest values that can be sent that way are written.</source>
        <translation>Dieser Controller setzt Kalibrierungsbytes als niederes + 256 × höheres zusammen: geschrieben werden die nächsten Werte, die sich so senden lassen.</translation>
    </message>
    <message>
        <source>channels: bit 0 is channel 1; default 0x1F, all</source>
        <translation>Kanäle: Bit 0 ist Kanal 1; Standard 0x1F, alle</translation>
    </message>
    <message>
        <source>no pulse</source>
        <translation>kein Impuls</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Rohwert</translation>
    </message>
    <message>
        <source>Remapped</source>
        <translation>Umgerechnet</translation>
    </message>
    <message>
        <source>Nothing differs.</source>
        <translation>Keine Unterschiede.</translation>
    </message>
    <message>
        <source>%1 parameters and the calibrations in force are saved to %2.</source>
        <translation>%1 Parameter und die geltenden Kalibrierungen sind in %2 gespeichert.</translation>
    </message>
    <message>
        <source>write nothing; show the changes and their packets</source>
        <translation>nichts schreiben; die Änderungen und ihre Pakete zeigen</translation>
    </message>
    <message>
        <source>Some of it acts after the controller&apos;s power is switched off and on.</source>
        <translation>Ein Teil davon wirkt erst nach Aus- und Einschalten des Controllers.</translation>
    </message>
    <message>
        <source>write the samples to a file, too, one row each</source>
        <translation>die Messwerte auch in eine Datei schreiben, je eine Zeile</translation>
    </message>
    <message>
        <source>Joint motor mode: the controller measures no currents while both H-bridges drive one motor.</source>
        <translation>Gemeinsamer Motormodus: der Controller misst keine Ströme, solange beide H-Brücken einen Motor treiben.</translation>
    </message>
    <message>
        <source>Motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>Motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>Pololu packets to device %1</source>
        <translation>Pololu-Pakete an Gerät %1</translation>
    </message>
    <message>
        <source>compact packets</source>
        <translation>kompakte Pakete</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controller</translation>
    </message>
    <message>
        <source>%1, firmware %2 (%3)</source>
        <translation>%1, Firmware %2 (%3)</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>serial is in control</source>
        <translation>seriell gesteuert</translation>
    </message>
    <message>
        <source>the channels are in control</source>
        <translation>von den Kanälen gesteuert</translation>
    </message>
    <message>
        <source>Learned channels</source>
        <translation>Gelernte Kanäle</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Leitung</translation>
    </message>
    <message>
        <source>%1 baud, error detection %2, %3, %4</source>
        <translation>%1 Baud, Fehlererkennung %2, %3, %4</translation>
    </message>
    <message>
        <source>with echo</source>
        <translation>mit Echo</translation>
    </message>
    <message>
        <source>no echo</source>
        <translation>ohne Echo</translation>
    </message>
    <message>
        <source>motor 1 over its current limit</source>
        <translation>Überstrom Motor 1</translation>
    </message>
    <message>
        <source>motor 1 driver fault</source>
        <translation>Treiberstörung Motor 1</translation>
    </message>
    <message>
        <source>motor 2 over its current limit</source>
        <translation>Überstrom Motor 2</translation>
    </message>
    <message>
        <source>motor 2 driver fault</source>
        <translation>Treiberstörung Motor 2</translation>
    </message>
    <message>
        <source>UART error</source>
        <translation>UART-Fehler</translation>
    </message>
    <message>
        <source>serial timeout</source>
        <translation>serielle Zeitüberschreitung</translation>
    </message>
    <message>
        <source>packet format</source>
        <translation>Paketformat</translation>
    </message>
    <message>
        <source>CRC</source>
        <translation>CRC</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>data overrun</source>
        <translation>Datenüberlauf</translation>
    </message>
    <message>
        <source>parity</source>
        <translation>Parität</translation>
    </message>
    <message>
        <source>read buffer overrun</source>
        <translation>Lesepufferüberlauf</translation>
    </message>
    <message>
        <source>send buffer overrun</source>
        <translation>Sendepufferüberlauf</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>UART errors</source>
        <translation>UART-Fehler</translation>
    </message>
    <message>
        <source>A reply was lost on the line and asked for again: bits that it carried may be missing here.</source>
        <translation>Eine Antwort ging auf der Leitung verloren und wurde erneut angefordert: Bits, die sie trug, können hier fehlen.</translation>
    </message>
    <message>
        <source>nothing latched</source>
        <translation>nichts gespeichert</translation>
    </message>
    <message>
        <source>such as 1,2; default: all five</source>
        <translation>etwa 1,2; Standard: alle fünf</translation>
    </message>
    <message>
        <source>rest needed for neutral; default 2</source>
        <translation>nötige Ruhe für Neutral; Standard 2</translation>
    </message>
    <message>
        <source>least time for the extremes; default 6</source>
        <translation>Mindestzeit für die Endlagen; Standard 6</translation>
    </message>
    <message>
        <source>ask nothing: start at once, and write at the end</source>
        <translation>nichts fragen: sofort beginnen und am Ende schreiben</translation>
    </message>
    <message>
        <source>A calibration asks before it writes: use a terminal, or --yes. Nothing was sent.</source>
        <translation>Eine Kalibrierung fragt vor dem Schreiben nach: ein Terminal oder --yes verwenden. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>Neutral: leave all sticks and switches at rest and let go.</source>
        <translation>Neutral: alle Knüppel und Schalter in Ruhestellung lassen und loslassen.</translation>
    </message>
    <message>
        <source>Not confirmed. Nothing was written.</source>
        <translation>Nicht bestätigt. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Write these calibrations to the controller?</source>
        <translation>Diese Kalibrierungen in den Controller schreiben?</translation>
    </message>
    <message>
        <source>%1 Nothing was written; --channels chooses the channels.</source>
        <translation>%1 Nichts wurde geschrieben; --channels wählt die Kanäle.</translation>
    </message>
    <message>
        <source>Channel %1: %2</source>
        <translation>Kanal %1: %2</translation>
    </message>
    <message>
        <source>Aux</source>
        <translation>Hilfsmotor</translation>
    </message>
    <message>
        <source>The command was sent, but nobody confirms it: %1</source>
        <translation>Der Befehl wurde gesendet, aber niemand bestätigt ihn: %1</translation>
    </message>
    <message>
        <source>1, 2, both or aux</source>
        <translation>1, 2, both oder aux</translation>
    </message>
    <message>
        <source>set, accelerate or brake</source>
        <translation>set, accelerate oder brake</translation>
    </message>
    <message>
        <source>-127 to 127 (aux 0 to 127); braking duty 0 to 127; both: one for both, or two</source>
        <translation>-127 bis 127 (aux 0 bis 127); Bremsgrad 0 bis 127; both: einer für beide oder zwei</translation>
    </message>
    <message>
        <source>Serial does not control the motors now: the command waits in the controller and acts as soon as serial override begins.</source>
        <translation>Die Motoren werden jetzt nicht seriell gesteuert: der Befehl wartet im Controller und wirkt, sobald die serielle Übernahme beginnt.</translation>
    </message>
    <message>
        <source>There is no motor &apos;%1&apos;: give 1, 2, both or aux. Nothing was sent.</source>
        <translation>Es gibt keinen Motor &apos;%1&apos;: 1, 2, both oder aux angeben. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>The auxiliary motor cannot brake: set it to 0 instead. Nothing was sent.</source>
        <translation>Der Hilfsmotor kann nicht bremsen: stattdessen auf 0 setzen. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>A motor cannot &apos;%1&apos;: give set, accelerate or brake. Nothing was sent.</source>
        <translation>Ein Motor kann nicht &apos;%1&apos;: set, accelerate oder brake angeben. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>Two numbers are for &apos;motor both&apos; only. Nothing was sent.</source>
        <translation>Zwei Zahlen gelten nur für &apos;motor both&apos;. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>motors 1 and 2 at full brake duty instead of coasting</source>
        <translation>Motoren 1 und 2 mit vollem Bremsgrad statt auslaufend</translation>
    </message>
    <message>
        <source>Serial does not control the motors now: the channels may still drive them. The stop acts as soon as serial override begins.</source>
        <translation>Die Motoren werden jetzt nicht seriell gesteuert: die Kanäle können sie weiter antreiben. Der Stopp wirkt, sobald die serielle Übernahme beginnt.</translation>
    </message>
    <message>
        <source>%1 (a guess)</source>
        <translation>%1 (vermutet)</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>%1, after a power cycle</source>
        <translation>%1, nach Aus- und Einschalten</translation>
    </message>
    <message>
        <source>key or number</source>
        <translation>Schlüssel oder Nummer</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>%1 (raw %2)</source>
        <translation>%1 (Rohwert %2)</translation>
    </message>
    <message>
        <source>Acts</source>
        <translation>Wirkt</translation>
    </message>
    <message>
        <source>after the next power cycle: not in force yet</source>
        <translation>nach dem nächsten Aus- und Einschalten: gilt noch nicht</translation>
    </message>
    <message>
        <source>after a power cycle</source>
        <translation>nach Aus- und Einschalten</translation>
    </message>
    <message>
        <source>It acts after the controller&apos;s power is switched off and on.</source>
        <translation>Wirkt erst nach Aus- und Einschalten des Controllers.</translation>
    </message>
    <message>
        <source>raw, or with its unit: 500ms, 2.4A</source>
        <translation>Rohwert oder mit Einheit: 500ms, 2.4A</translation>
    </message>
    <message>
        <source>do not read it back</source>
        <translation>nicht zurücklesen</translation>
    </message>
    <message>
        <source>, verified</source>
        <translation>, geprüft</translation>
    </message>
    <message>
        <source>%1 is between two steps: the nearest is %2.</source>
        <translation>%1 liegt zwischen zwei Stufen: die nächste ist %2.</translation>
    </message>
    <message>
        <source>do not ask</source>
        <translation>nicht nachfragen</translation>
    </message>
    <message>
        <source>A factory reset needs --yes where nobody can be asked. Nothing was sent.</source>
        <translation>Zurücksetzen auf Werkseinstellungen erfordert ohne Rückfrage --yes. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>Reset all parameters of the controller on %1 to factory defaults? Calibrations stay.</source>
        <translation>Alle Parameter des Controllers an %1 auf Werkseinstellungen zurücksetzen? Kalibrierungen bleiben.</translation>
    </message>
    <message>
        <source>Not confirmed. Nothing was sent.</source>
        <translation>Nicht bestätigt. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>All parameters are reset to factory defaults.</source>
        <translation>Alle Parameter sind auf Werkseinstellungen zurückgesetzt.</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Hersteller</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>USB</source>
        <translation>USB</translation>
    </message>
    <message>
        <source>There is no serial port. Plug in the adapter, or use --port sim: for the built-in simulator.</source>
        <translation>Kein serieller Port vorhanden. Adapter einstecken oder --port sim: für den eingebauten Simulator verwenden.</translation>
    </message>
    <message>
        <source>go on after the first, and ask all 128 device numbers</source>
        <translation>nach dem ersten weitersuchen und alle 128 Gerätenummern abfragen</translation>
    </message>
    <message>
        <source>Baud</source>
        <translation>Baud</translation>
    </message>
    <message>
        <source>Error detection</source>
        <translation>Fehlererkennung</translation>
    </message>
    <message>
        <source>Stop bits</source>
        <translation>Stoppbits</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Echo</source>
        <translation>Echo</translation>
    </message>
    <message>
        <source>bytes in hex: 861F, or 86 1F</source>
        <translation>Bytes in Hex: 861F oder 86 1F</translation>
    </message>
    <message>
        <source>bytes to wait for, without CRC byte; default: as the command says</source>
        <translation>erwartete Bytes, ohne CRC-Byte; Standard: wie im Befehl festgelegt</translation>
    </message>
    <message>
        <source>as a packet of the chosen form with its CRC: command byte, data</source>
        <translation>als Paket der gewählten Form mit CRC: Befehlsbyte, Daten</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not bytes in hex, such as 861F. Nothing was sent.</source>
        <translation>&apos;%1&apos; sind keine Bytes in Hex, wie etwa 861F. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Gesendet</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Empfangen</translation>
    </message>
    <message>
        <source>A packet is a command byte of 80 or more and data bytes below 80. Nothing was sent.</source>
        <translation>Ein Paket besteht aus einem Befehlsbyte ab 80 und Datenbytes unter 80. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>serve on a pseudo-terminal with this link to it (the default, without a link)</source>
        <translation>an einem Pseudoterminal mit diesem Link darauf bereitstellen (Standard, ohne Link)</translation>
    </message>
    <message>
        <source>jr (default) or trex</source>
        <translation>jr (Standard) oder trex</translation>
    </message>
    <message>
        <source>1.0 to 1.3, default 1.2</source>
        <translation>1.0 bis 1.3, Standard 1.2</translation>
    </message>
    <message>
        <source>mode jumper: rc, analog or serial (default)</source>
        <translation>Modus-Steckbrücke: rc, analog oder serial (Standard)</translation>
    </message>
    <message>
        <source>as stored in the controller, default 19200</source>
        <translation>wie im Controller gespeichert, Standard 19200</translation>
    </message>
    <message>
        <source>none (default), even, odd or crc7</source>
        <translation>none (Standard), even, odd oder crc7</translation>
    </message>
    <message>
        <source>8 bits, top bit set; default 0x89</source>
        <translation>8 Bit, oberstes Bit gesetzt; Standard 0x89</translation>
    </message>
    <message>
        <source>1 (default) or 2</source>
        <translation>1 (Standard) oder 2</translation>
    </message>
    <message>
        <source>device number, default 7; several are several controllers on one line</source>
        <translation>Gerätenummer, Standard 7; mehrere sind mehrere Controller an einer Leitung</translation>
    </message>
    <message>
        <source>keeps the EEPROM; starting again with it is a power cycle</source>
        <translation>bewahrt das EEPROM; ein neuer Start damit ist ein Aus- und Einschalten</translation>
    </message>
    <message>
        <source>of faults, jitter and noise; default 1</source>
        <translation>für Störungen, Jitter und Rauschen; Standard 1</translation>
    </message>
    <message>
        <source>a parameter of a fresh EEPROM, raw</source>
        <translation>ein Parameter eines neuen EEPROM, als Rohwert</translation>
    </message>
    <message>
        <source>calibration-bytes=8, null-command=error, unknown-parameter=ff, serial-timeout=off, safe-start=on, motor-reply=ff, invalid-after=150</source>
        <translation>calibration-bytes=8, null-command=error, unknown-parameter=ff, serial-timeout=off, safe-start=on, motor-reply=ff, invalid-after=150</translation>
    </message>
    <message>
        <source>channel signals and events (JSON)</source>
        <translation>Kanalsignale und Ereignisse (JSON)</translation>
    </message>
    <message>
        <source>virtual seconds a real second, default 1</source>
        <translation>virtuelle Sekunden je reale Sekunde, Standard 1</translation>
    </message>
    <message>
        <source>packets heard and motor outputs, as JSON Lines</source>
        <translation>empfangene Pakete und Motorausgänge, als JSON Lines</translation>
    </message>
    <message>
        <source>bytes take their time on the wire</source>
        <translation>Bytes brauchen ihre Zeit auf der Leitung</translation>
    </message>
    <message>
        <source>RS-232 wiring: the host hears itself</source>
        <translation>RS-232-Verdrahtung: der Host hört sich selbst</translation>
    </message>
    <message>
        <source>mix jumper</source>
        <translation>Mix-Steckbrücke</translation>
    </message>
    <message>
        <source>Find and identify</source>
        <translation>Suchen und erkennen</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>Einrichten</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Motoren steuern</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>serial ports present</source>
        <translation>vorhandene serielle Ports</translation>
    </message>
    <message>
        <source>find controllers on --port, whatever their line settings</source>
        <translation>Controller an --port finden, bei beliebigen Leitungseinstellungen</translation>
    </message>
    <message>
        <source>signature, mode, who controls the motors, learned channels</source>
        <translation>Signatur, Modus, wer die Motoren steuert, gelernte Kanäle</translation>
    </message>
    <message>
        <source>status byte and UART error byte; reading clears both in the controller</source>
        <translation>Statusbyte und UART-Fehlerbyte; das Lesen löscht beide im Controller</translation>
    </message>
    <message>
        <source>raw and remapped inputs, once or as a stream</source>
        <translation>rohe und umgerechnete Eingänge, einmal oder fortlaufend</translation>
    </message>
    <message>
        <source>motor currents, once or as a stream</source>
        <translation>Motorströme, einmal oder fortlaufend</translation>
    </message>
    <message>
        <source>calibrations of the input set in force</source>
        <translation>Kalibrierungen der geltenden Eingänge</translation>
    </message>
    <message>
        <source>write one channel&apos;s calibration and read it back</source>
        <translation>Kalibrierung eines Kanals schreiben und zurücklesen</translation>
    </message>
    <message>
        <source>guided: rest, move to the extremes, confirm, write</source>
        <translation>geführt: Ruhe, in die Endlagen bewegen, bestätigen, schreiben</translation>
    </message>
    <message>
        <source>all configuration parameters</source>
        <translation>alle Konfigurationsparameter</translation>
    </message>
    <message>
        <source>one parameter, by key or number</source>
        <translation>ein Parameter, nach Schlüssel oder Nummer</translation>
    </message>
    <message>
        <source>write one parameter and read it back</source>
        <translation>einen Parameter schreiben und zurücklesen</translation>
    </message>
    <message>
        <source>all parameters to factory defaults</source>
        <translation>alle Parameter auf Werkseinstellungen</translation>
    </message>
    <message>
        <source>all parameters and calibrations in force to a JSON file</source>
        <translation>alle Parameter und geltenden Kalibrierungen in eine JSON-Datei speichern</translation>
    </message>
    <message>
        <source>write what differs from a file; puts all back when one is refused</source>
        <translation>schreiben, was von einer Datei abweicht; stellt alles wieder her, wenn etwas abgelehnt wird</translation>
    </message>
    <message>
        <source>what differs between the controller and a file</source>
        <translation>was zwischen Controller und Datei verschieden ist</translation>
    </message>
    <message>
        <source>set, accelerate or brake motor 1, 2, both or aux; it keeps running</source>
        <translation>Motor 1, 2, both oder aux setzen, beschleunigen oder bremsen; er läuft weiter</translation>
    </message>
    <message>
        <source>all three motors to speed 0 now, or 1 and 2 to full brake</source>
        <translation>alle drei Motoren sofort auf Drehzahl 0, oder 1 und 2 voll bremsen</translation>
    </message>
    <message>
        <source>send bytes as given, or framed as a packet</source>
        <translation>Bytes wie angegeben oder als Paket senden</translation>
    </message>
    <message>
        <source>a simulated controller that other programs can open</source>
        <translation>ein simulierter Controller, den andere Programme öffnen können</translation>
    </message>
    <message>
        <source>channel calibrations: get, set, learn</source>
        <translation>Kanalkalibrierungen: get, set, learn</translation>
    </message>
    <message>
        <source>configuration parameters: list, get, set, reset</source>
        <translation>Konfigurationsparameter: list, get, set, reset</translation>
    </message>
    <message>
        <source>whole configurations as files: save, load, diff</source>
        <translation>ganze Konfigurationen als Dateien: save, load, diff</translation>
    </message>
    <message>
        <source>neither channels nor currents were recorded</source>
        <translation>weder Kanäle noch Ströme wurden aufgezeichnet</translation>
    </message>
    <message>
        <source>samples a second, default 20</source>
        <translation>Messwerte je Sekunde, Standard 20</translation>
    </message>
    <message>
        <source>seconds; without it until SIGINT (Ctrl+C)</source>
        <translation>Dauer in Sekunden; ohne Angabe bis SIGINT (Strg+C)</translation>
    </message>
    <message>
        <source>of the checkpoint</source>
        <translation>des Sicherungspunkts</translation>
    </message>
    <message>
        <source>A checkpoint needs a name. Nothing was sent.</source>
        <translation>Ein Sicherungspunkt braucht einen Namen. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>The whole configuration is kept as checkpoint %1.</source>
        <translation>Die ganze Konfiguration ist als Sicherungspunkt %1 festgehalten.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>(before a first write)</source>
        <translation>(vor einem ersten Schreiben)</translation>
    </message>
    <message>
        <source>There is no checkpoint.</source>
        <translation>Es gibt keinen Sicherungspunkt.</translation>
    </message>
    <message>
        <source>There is no checkpoint %1 on %2. See: trexctl checkpoint list</source>
        <translation>Es gibt keinen Sicherungspunkt %1 an %2. Siehe: trexctl checkpoint list</translation>
    </message>
    <message>
        <source>%1 controllers on %2 have a checkpoint %3: delete it in the window.</source>
        <translation>%1 Controller an %2 haben einen Sicherungspunkt %3: im Fenster löschen.</translation>
    </message>
    <message>
        <source>The checkpoint %1 is deleted.</source>
        <translation>Der Sicherungspunkt %1 ist gelöscht.</translation>
    </message>
    <message>
        <source>configuration file (JSON); texts under keys of your own are comments</source>
        <translation>Konfigurationsdatei (JSON); Texte unter eigenen Schlüsseln sind Kommentare</translation>
    </message>
    <message>
        <source>another one: compare the two, without a controller</source>
        <translation>eine weitere: beide vergleichen, ohne Controller</translation>
    </message>
    <message>
        <source>compare the controller with the factory defaults</source>
        <translation>den Controller mit den Werkseinstellungen vergleichen</translation>
    </message>
    <message>
        <source>--defaults takes no file.</source>
        <translation>--defaults nimmt keine Datei.</translation>
    </message>
    <message>
        <source>Give a file to compare with, or --defaults.</source>
        <translation>Eine Datei zum Vergleichen oder --defaults angeben.</translation>
    </message>
    <message>
        <source>%1: only in %2</source>
        <translation>%1: nur in %2</translation>
    </message>
    <message>
        <source>The vendor does not state these defaults, they are guesses: %1.</source>
        <translation>Der Hersteller gibt diese Standardwerte nicht an, sie sind vermutet: %1.</translation>
    </message>
    <message>
        <source>Calibrations are not compared: their defaults are not documented.</source>
        <translation>Kalibrierungen werden nicht verglichen: Ihre Standardwerte sind nicht dokumentiert.</translation>
    </message>
    <message>
        <source>a recording</source>
        <translation>eine Aufzeichnung</translation>
    </message>
    <message>
        <source>the file to write: one row a sample</source>
        <translation>zu schreibende Datei: eine Zeile je Messwert</translation>
    </message>
    <message>
        <source>%1: %2 rows</source>
        <translation>%1: %2 Zeilen</translation>
    </message>
    <message>
        <source>of all ports, not only of --port</source>
        <translation>aller Ports, nicht nur von --port</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>the entry; it and all after it are undone</source>
        <translation>der Eintrag; er und alle danach werden rückgängig gemacht</translation>
    </message>
    <message>
        <source>journal entry %1 of this controller</source>
        <translation>Journaleintrag %1 dieses Controllers</translation>
    </message>
    <message>
        <source>In this mode the sticks also move the motors: keep the motors&apos; power off.</source>
        <translation>In diesem Modus bewegen auch die Knüppel die Motoren: Versorgung der Motoren ausgeschaltet lassen.</translation>
    </message>
    <message>
        <source>the recording; a new file</source>
        <translation>die Aufzeichnung; eine neue Datei</translation>
    </message>
    <message>
        <source>some of currents,channels,status; default all</source>
        <translation>einige von currents,channels,status; Standard alle</translation>
    </message>
    <message>
        <source>every packet and its reply, too</source>
        <translation>auch jedes Paket und seine Antwort</translation>
    </message>
    <message>
        <source>replace a file that is there</source>
        <translation>eine vorhandene Datei ersetzen</translation>
    </message>
    <message>
        <source>--streams: &apos;%1&apos; is none of currents, channels, status; nothing was sent.</source>
        <translation>--streams: &apos;%1&apos; ist keines von currents, channels, status; nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>There is already a file %1; give another name, or --force to replace it. Nothing was sent.</source>
        <translation>Es gibt bereits eine Datei %1; einen anderen Namen angeben oder --force, um sie zu ersetzen. Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>motor currents</source>
        <translation>Motorströme</translation>
    </message>
    <message>
        <source>Joint motor mode: the controller measures no currents, so they are left out.</source>
        <translation>Gemeinsamer Motormodus: Der Controller misst keine Ströme, sie werden daher ausgelassen.</translation>
    </message>
    <message>
        <source>%1 samples, %2 s, %3 lost</source>
        <translation>%1 Messwerte, %2 s, %3 verloren</translation>
    </message>
    <message>
        <source>a crash-safe recording of currents, channels, status, settings</source>
        <translation>eine absturzsichere Aufzeichnung von Strömen, Kanälen, Status, Einstellungen</translation>
    </message>
    <message>
        <source>a recording to CSV</source>
        <translation>eine Aufzeichnung als CSV</translation>
    </message>
    <message>
        <source>every write that went to a controller on --port: old, new, result</source>
        <translation>jedes Schreiben in einen Controller an --port: alt, neu, Ergebnis</translation>
    </message>
    <message>
        <source>write back what the controller held before an entry</source>
        <translation>zurückschreiben, was der Controller vor einem Eintrag enthielt</translation>
    </message>
    <message>
        <source>keep the whole configuration under a name</source>
        <translation>die ganze Konfiguration unter einem Namen festhalten</translation>
    </message>
    <message>
        <source>what was kept from controllers on --port, by name or by itself</source>
        <translation>was von Controllern an --port festgehalten wurde, unter einem Namen oder von selbst</translation>
    </message>
    <message>
        <source>write what differs from a checkpoint</source>
        <translation>schreiben, was von einem Sicherungspunkt abweicht</translation>
    </message>
    <message>
        <source>forget a checkpoint</source>
        <translation>einen Sicherungspunkt löschen</translation>
    </message>
    <message>
        <source>whole configurations by name: save, list, restore, delete</source>
        <translation>ganze Konfigurationen unter Namen: save, list, restore, delete</translation>
    </message>
    <message>
        <source>Extremes: move every stick and switch to all its ends, and hold it at each for a second.</source>
        <translation>Enden: Bewegen Sie jeden Knüppel und Schalter an alle seine Enden, und halten Sie ihn dort je eine Sekunde lang.</translation>
    </message>
    <message>
        <source>Channel %1: %2. %3</source>
        <translation>Kanal %1: %2. %3</translation>
    </message>
    <message>
        <source>This controller joins calibration bytes as low + 256 × high: channels %1 hold the nearest values that can be sent that way, read back.</source>
        <translation>Dieser Regler setzt die Bytes einer Kalibrierung als niedrig + 256 × hoch zusammen: Die Kanäle %1 enthalten die nächstliegenden Werte, die so gesendet werden können; zurückgelesen.</translation>
    </message>
    <message>
        <source>a bench test: a JSON file, or a ready one: %1</source>
        <translation>eine Prüfung: eine JSON-Datei oder eine fertige: %1</translation>
    </message>
    <message>
        <source>everything into a recording; a new file</source>
        <translation>alles in eine Aufzeichnung; eine neue Datei</translation>
    </message>
    <message>
        <source>a report with plots; a new file</source>
        <translation>ein Bericht mit Diagrammen; eine neue Datei</translation>
    </message>
    <message>
        <source>replace files that are there</source>
        <translation>vorhandene Dateien ersetzen</translation>
    </message>
    <message>
        <source>Bench test: %1</source>
        <translation>Prüfung: %1</translation>
    </message>
    <message>
        <source>Interrupted; the motors were told to stop.</source>
        <translation>Unterbrochen; den Motoren wurde Halt befohlen.</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Proposed: %1 %2 (%3)</source>
        <translation>Vorschlag: %1 %2 (%3)</translation>
    </message>
    <message>
        <source>%1 of %2 s, step %3</source>
        <translation>%1 von %2 s, Schritt %3</translation>
    </message>
    <message>
        <source>a recording&apos;s channels, currents and parameters, from its beginning</source>
        <translation>Kanäle, Ströme und Parameter einer Aufzeichnung, von ihrem Anfang an</translation>
    </message>
    <message>
        <source>a bench test: steps, ramps, sines on the motors, with limits that stop it</source>
        <translation>eine Prüfung: Sprünge, Rampen, Sinus auf den Motoren, mit Grenzen, die sie anhalten</translation>
    </message>
    <message>
        <source>seconds to look at the line, default 5</source>
        <translation>Sekunden, die die Leitung beobachtet wird; Standard 5</translation>
    </message>
    <message>
        <source>Serial does not control the motors now, and a drive with --duration does not wait for it.</source>
        <translation>Die serielle Schnittstelle steuert die Motoren jetzt nicht, und eine Fahrt mit --duration wartet nicht darauf.</translation>
    </message>
    <message>
        <source>The drive has ended before its time: %1</source>
        <translation>Die Fahrt hat vor ihrer Zeit geendet: %1</translation>
    </message>
    <message>
        <source>stop all motors after this many seconds, and when interrupted; without it the motors are left as told</source>
        <translation>nach so vielen Sekunden und bei einer Unterbrechung alle Motoren anhalten; ohne diese Option bleiben die Motoren, wie befohlen</translation>
    </message>
    <message>
        <source>Interrupted; stop could not be sent: %1</source>
        <translation>Unterbrochen; der Halt konnte nicht gesendet werden: %1</translation>
    </message>
    <message>
        <source>Listening on %1: whoever reaches this computer can drive this simulated controller. --tcp PORT alone serves this computer only.</source>
        <translation>Erreichbar unter %1: Wer diesen Rechner erreicht, kann diesen simulierten Controller steuern. --tcp PORT allein bedient nur diesen Rechner.</translation>
    </message>
    <message>
        <source>--tcp %1 (PORT, or ADDRESS:PORT such as 0.0.0.0:4000)</source>
        <translation>--tcp %1 (PORT oder ADRESSE:PORT, etwa 0.0.0.0:4000)</translation>
    </message>
    <message>
        <source>serve on 127.0.0.1:PORT; 0 takes a free one; ADDRESS:PORT: for other computers, too</source>
        <translation>an 127.0.0.1:PORT bedienen; 0 nimmt einen freien; ADRESSE:PORT: auch für andere Rechner</translation>
    </message>
    <message>
        <source>drop, corrupt, duplicate (chance a byte), delay (ms), garbage (bytes), silent-after, silent-for, hangup-after, hangup-for, reset-after (s); drop-sent, corrupt-sent, repeat-sent (chance a byte of the host), unplugged (controllers)</source>
        <translation>drop, corrupt, duplicate (Wahrscheinlichkeit je Byte), delay (ms), garbage (Bytes), silent-after, silent-for, hangup-after, hangup-for, reset-after (s); drop-sent, corrupt-sent, repeat-sent (Wahrscheinlichkeit je Byte des Rechners), unplugged (Controller)</translation>
    </message>
    <message>
        <source>how well the line does, and what would help; reading clears the UART error byte</source>
        <translation>wie gut die Leitung arbeitet und was helfen würde; das Lesen löscht das UART-Fehlerbyte</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Pololu packet</source>
        <translation>Pololu-Paket</translation>
    </message>
    <message>
        <source>Starts a packet for one device on a shared line: device number, then the command with its top bit cleared.</source>
        <translation>Beginnt ein Paket für ein Gerät an einer gemeinsamen Leitung: Gerätenummer, dann der Befehl mit gelöschtem obersten Bit.</translation>
    </message>
    <message>
        <source>Get signature</source>
        <translation>Signatur lesen</translation>
    </message>
    <message>
        <source>Product name and firmware version: nine bytes from a TReX Jr, seven from a TReX.</source>
        <translation>Produktname und Firmware-Version: neun Bytes von einem TReX Jr, sieben von einem TReX.</translation>
    </message>
    <message>
        <source>Get mode</source>
        <translation>Modus lesen</translation>
    </message>
    <message>
        <source>Mode set by the mode jumper: R RC, A analog, r serial with RC inputs, a serial with analog inputs.</source>
        <translation>Von der Modus-Steckbrücke bestimmter Modus: R RC, A analog, r seriell mit RC-Eingängen, a seriell mit Analogeingängen.</translation>
    </message>
    <message>
        <source>Does serial control the motors?</source>
        <translation>Werden die Motoren seriell gesteuert?</translation>
    </message>
    <message>
        <source>1 in serial mode or while channel 5 overrides, else 0.</source>
        <translation>1 im seriellen Modus oder während der Übernahme durch Kanal 5, sonst 0.</translation>
    </message>
    <message>
        <source>Get status byte</source>
        <translation>Statusbyte lesen</translation>
    </message>
    <message>
        <source>Faults and over-current of both motors, UART error. Reading clears the latched bits in the controller.</source>
        <translation>Störungen und Überstrom beider Motoren, UART-Fehler. Das Lesen löscht die gespeicherten Bits im Controller.</translation>
    </message>
    <message>
        <source>Get UART error byte</source>
        <translation>UART-Fehlerbyte lesen</translation>
    </message>
    <message>
        <source>What was wrong on the serial line. Reading clears the latched bits in the controller.</source>
        <translation>Was auf der seriellen Leitung falsch war. Das Lesen löscht die gespeicherten Bits im Controller.</translation>
    </message>
    <message>
        <source>Get raw channel values</source>
        <translation>Rohe Kanalwerte lesen</translation>
    </message>
    <message>
        <source>Inputs as measured: pulse widths of 0.4 µs (0xFFFF is no valid pulse) or 10-bit voltages.</source>
        <translation>Eingänge wie gemessen: Impulsbreiten zu 0.4 µs (0xFFFF ist kein gültiger Impuls) oder 10-Bit-Spannungen.</translation>
    </message>
    <message>
        <source>Get remapped channel values</source>
        <translation>Umgerechnete Kanalwerte lesen</translation>
    </message>
    <message>
        <source>Inputs after calibration, reversal, curve, mix and flip: what the motors would be told.</source>
        <translation>Eingänge nach Kalibrierung, Umkehr, Kurve, Mischung und Überkopftausch: was den Motoren vorgegeben würde.</translation>
    </message>
    <message>
        <source>Get motor 1 current</source>
        <translation>Strom von Motor 1 lesen</translation>
    </message>
    <message>
        <source>Averaged current, 40 mA a unit on a TReX Jr. Independent motor mode only.</source>
        <translation>Gemittelter Strom, 40 mA je Einheit beim TReX Jr. Nur im unabhängigen Motormodus.</translation>
    </message>
    <message>
        <source>Get motor 2 current</source>
        <translation>Strom von Motor 2 lesen</translation>
    </message>
    <message>
        <source>Get motor currents</source>
        <translation>Motorströme lesen</translation>
    </message>
    <message>
        <source>Currents of motor 1 and motor 2 in one reply.</source>
        <translation>Ströme von Motor 1 und Motor 2 in einer Antwort.</translation>
    </message>
    <message>
        <source>Get channel calibration</source>
        <translation>Kanalkalibrierung lesen</translation>
    </message>
    <message>
        <source>Minimum, neutral, maximum and deadband of one channel, of the input set in force.</source>
        <translation>Minimum, Neutral, Maximum und Totband eines Kanals, für die geltenden Eingänge.</translation>
    </message>
    <message>
        <source>Get calibrated channels</source>
        <translation>Kalibrierte Kanäle lesen</translation>
    </message>
    <message>
        <source>Channels whose calibration differs from the defaults.</source>
        <translation>Kanäle, deren Kalibrierung vom Standard abweicht.</translation>
    </message>
    <message>
        <source>Get configuration parameter</source>
        <translation>Konfigurationsparameter lesen</translation>
    </message>
    <message>
        <source>The stored value of one configuration parameter.</source>
        <translation>Der gespeicherte Wert eines Konfigurationsparameters.</translation>
    </message>
    <message>
        <source>Set channel calibration</source>
        <translation>Kanalkalibrierung setzen</translation>
    </message>
    <message>
        <source>Stores one channel&apos;s calibration (serial mode only). Answers when stored, after about 32 ms.</source>
        <translation>Speichert die Kalibrierung eines Kanals (nur im seriellen Modus). Antwortet nach dem Speichern, nach etwa 32 ms.</translation>
    </message>
    <message>
        <source>Set configuration parameter</source>
        <translation>Konfigurationsparameter setzen</translation>
    </message>
    <message>
        <source>Stores one configuration parameter (serial mode only). Answers when stored, after about 4 ms.</source>
        <translation>Speichert einen Konfigurationsparameter (nur im seriellen Modus). Antwortet nach dem Speichern, nach etwa 4 ms.</translation>
    </message>
    <message>
        <source>Set motor 1</source>
        <translation>Motor 1 setzen</translation>
    </message>
    <message>
        <source>Sets speed and direction, or braking duty, at once; overrides current limiting for the moment.</source>
        <translation>Setzt Drehzahl und Richtung oder Bremsgrad sofort; übergeht dabei vorübergehend die Strombegrenzung.</translation>
    </message>
    <message>
        <source>Accelerate motor 1</source>
        <translation>Motor 1 beschleunigen</translation>
    </message>
    <message>
        <source>Sets the target speed; the controller accelerates to it every 10 ms and keeps to the current limit.</source>
        <translation>Setzt die Zieldrehzahl; der Controller beschleunigt im Takt von 10 ms dorthin und hält die Stromgrenze ein.</translation>
    </message>
    <message>
        <source>Set motor 2</source>
        <translation>Motor 2 setzen</translation>
    </message>
    <message>
        <source>Accelerate motor 2</source>
        <translation>Motor 2 beschleunigen</translation>
    </message>
    <message>
        <source>Set motors 1 and 2</source>
        <translation>Motoren 1 und 2 setzen</translation>
    </message>
    <message>
        <source>Sets both motors at once; overrides current limiting for the moment.</source>
        <translation>Setzt beide Motoren sofort; übergeht dabei vorübergehend die Strombegrenzung.</translation>
    </message>
    <message>
        <source>Accelerate motors 1 and 2</source>
        <translation>Motoren 1 und 2 beschleunigen</translation>
    </message>
    <message>
        <source>Sets the target speeds of both motors.</source>
        <translation>Setzt die Zieldrehzahlen beider Motoren.</translation>
    </message>
    <message>
        <source>Set auxiliary motor</source>
        <translation>Hilfsmotor setzen</translation>
    </message>
    <message>
        <source>Sets the speed of the auxiliary motor, one direction, at once.</source>
        <translation>Setzt die Drehzahl des Hilfsmotors sofort, in einer Richtung.</translation>
    </message>
    <message>
        <source>Accelerate auxiliary motor</source>
        <translation>Hilfsmotor beschleunigen</translation>
    </message>
    <message>
        <source>Sets the target speed of the auxiliary motor.</source>
        <translation>Setzt die Zieldrehzahl des Hilfsmotors.</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
</context>
<context>
    <name>ConfigFile</name>
    <message>
        <source>%1 (no ordinary file)</source>
        <translation>%1 (keine gewöhnliche Datei)</translation>
    </message>
    <message>
        <source>The file was written by a newer program (version %1).</source>
        <translation>Die Datei wurde von einem neueren Programm geschrieben (Version %1).</translation>
    </message>
    <message>
        <source>The file was written by a newer program (version %1); not understood and left out: %2.</source>
        <translation>Die Datei wurde von einem neueren Programm geschrieben (Version %1); nicht verstanden und ausgelassen: %2.</translation>
    </message>
    <message>
        <source>line %1, %2: stands twice</source>
        <translation>Zeile %1, %2: steht doppelt</translation>
    </message>
    <message>
        <source>must be &quot;trexpanel-configuration&quot;: this is no configuration file</source>
        <translation>muss &quot;trexpanel-configuration&quot; sein: dies ist keine Konfigurationsdatei</translation>
    </message>
    <message>
        <source>is missing, and so is calibration</source>
        <translation>fehlt, und calibration ebenso</translation>
    </message>
    <message>
        <source>a time such as 2026-11-22T14:00:00Z</source>
        <translation>eine Zeit wie 2026-11-22T14:00:00Z</translation>
    </message>
    <message>
        <source>%1 is no time such as 2026-11-22T14:00:00Z</source>
        <translation>%1 ist keine Zeit wie 2026-11-22T14:00:00Z</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>%1 is not the signature of a TReX</source>
        <translation>%1 ist nicht die Signatur eines TReX</translation>
    </message>
    <message>
        <source>is a command and not a setting</source>
        <translation>ist ein Befehl und keine Einstellung</translation>
    </message>
    <message>
        <source>%1 is no value of this parameter</source>
        <translation>%1 ist kein Wert dieses Parameters</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, but this parameter&apos;s unit is &quot;%2&quot;</source>
        <translation>ist &quot;%1&quot;, aber die Einheit dieses Parameters ist &quot;%2&quot;</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>%1 disagrees with raw %2, which is %3</source>
        <translation>%1 widerspricht dem Rohwert %2, der %3 entspricht</translation>
    </message>
    <message>
        <source>%1 is above neutral, %2</source>
        <translation>%1 liegt über Neutral, %2</translation>
    </message>
    <message>
        <source>%1 is above maximum, %2</source>
        <translation>%1 liegt über dem Maximum, %2</translation>
    </message>
    <message>
        <source>%1 equals minimum</source>
        <translation>%1 ist gleich dem Minimum</translation>
    </message>
    <message>
        <source>larger than 1 MiB, which no configuration is</source>
        <translation>größer als 1 MiB, was keine Konfiguration ist</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>must be an object in braces</source>
        <translation>muss ein Objekt in geschweiften Klammern sein</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>null</source>
        <translation>null</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>line %1, %2</source>
        <translation>Zeile %1, %2</translation>
    </message>
    <message>
        <source>must be %1, but is %2</source>
        <translation>muss %1 sein, ist aber %2</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>must be a whole number, but is %1</source>
        <translation>muss eine ganze Zahl sein, ist aber %1</translation>
    </message>
    <message>
        <source>%1 is out of range (%2…%3)</source>
        <translation>%1 liegt außerhalb des Bereichs (%2…%3)</translation>
    </message>
    <message>
        <source>about %1 (inferred)</source>
        <translation>etwa %1 (gefolgert)</translation>
    </message>
    <message>
        <source>%1: %2 is more than this controller can be set to; taken is its most, %3 (raw %4).</source>
        <translation>%1: %2 ist mehr, als sich an diesem Controller einstellen lässt; genommen wird sein Höchstwert, %3 (Rohwert %4).</translation>
    </message>
    <message>
        <source>%1: adapted from %2 to %3 (raw %4), since the two models count currents in different steps.</source>
        <translation>%1: von %2 auf %3 (Rohwert %4) angepasst, da die beiden Modelle Ströme in verschiedenen Stufen zählen.</translation>
    </message>
    <message>
        <source>The file is of a %1, the controller is a %2.</source>
        <translation>Die Datei stammt von einem %1, der Controller ist ein %2.</translation>
    </message>
    <message>
        <source>%1: taken as it is, though it acts on current in the other model&apos;s steps; try it with care.</source>
        <translation>%1: unverändert genommen, obwohl es auf den Strom in den Stufen des anderen Modells wirkt; mit Vorsicht erproben.</translation>
    </message>
    <message>
        <source>%1: left out, since firmware %2 does not have it.</source>
        <translation>%1: ausgelassen, da Firmware %2 es nicht hat.</translation>
    </message>
    <message>
        <source>Not understood and left alone in the file: %1.</source>
        <translation>Nicht verstanden und in der Datei belassen: %1.</translation>
    </message>
    <message>
        <source>is not known; is %1 meant?</source>
        <translation>ist unbekannt; ist %1 gemeint?</translation>
    </message>
    <message>
        <source>is not known here, and no comment, which would be a text</source>
        <translation>ist hier unbekannt und kein Kommentar, der ein Text wäre</translation>
    </message>
    <message>
        <source>the file is UTF-16; save it as UTF-8</source>
        <translation>die Datei ist UTF-16; als UTF-8 speichern</translation>
    </message>
    <message>
        <source>there is a NUL byte, which no text has</source>
        <translation>enthält ein NUL-Byte, das in keinem Text vorkommt</translation>
    </message>
    <message>
        <source>JSON has no comments; write a text under a key of its own, such as &quot;comment&quot;</source>
        <translation>JSON kennt keine Kommentare; einen Text unter einem eigenen Schlüssel schreiben, etwa &quot;comment&quot;</translation>
    </message>
    <message>
        <source>must be a text such as &quot;1.2&quot;</source>
        <translation>muss ein Text wie &quot;1.2&quot; sein</translation>
    </message>
    <message>
        <source>%1 disagrees with the signature, %2</source>
        <translation>%1 widerspricht der Signatur, %2</translation>
    </message>
    <message>
        <source>there are bytes that are no UTF-8; save it as UTF-8</source>
        <translation>sie enthält Bytes, die kein UTF-8 sind; als UTF-8 speichern</translation>
    </message>
</context>
<context>
    <name>CsvExport</name>
    <message>
        <source>not a plain file</source>
        <translation>keine gewöhnliche Datei</translation>
    </message>
</context>
<context>
    <name>Disarm</name>
    <message>
        <source>not armed yet</source>
        <translation>noch nicht scharf geschaltet</translation>
    </message>
    <message>
        <source>on request</source>
        <translation>auf Wunsch</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>auf Wunsch angehalten</translation>
    </message>
    <message>
        <source>the link was lost</source>
        <translation>die Verbindung ging verloren</translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation>getrennt</translation>
    </message>
    <message>
        <source>the controller was restarted</source>
        <translation>der Controller wurde neu gestartet</translation>
    </message>
    <message>
        <source>the screen was locked</source>
        <translation>der Bildschirm wurde gesperrt</translation>
    </message>
    <message>
        <source>the computer was going to sleep</source>
        <translation>der Rechner ging in den Ruhezustand</translation>
    </message>
    <message>
        <source>no window of the program was to be seen any more</source>
        <translation>kein Fenster des Programms war mehr zu sehen</translation>
    </message>
    <message>
        <source>no order was given for the idle time</source>
        <translation>während der Leerlaufzeit kam kein Befehl</translation>
    </message>
    <message>
        <source>the controller reports a motor fault</source>
        <translation>der Controller meldet einen Motorfehler</translation>
    </message>
    <message>
        <source>the controller reports too much current</source>
        <translation>der Controller meldet zu viel Strom</translation>
    </message>
    <message>
        <source>the controller reports an error on the line</source>
        <translation>der Controller meldet einen Fehler auf der Leitung</translation>
    </message>
    <message>
        <source>the controller&apos;s serial timeout has stopped the motors</source>
        <translation>die serielle Zeitüberwachung des Controllers hat die Motoren angehalten</translation>
    </message>
    <message>
        <source>the stall guard has stopped them</source>
        <translation>der Blockierschutz hat sie angehalten</translation>
    </message>
    <message>
        <source>the language was changed</source>
        <translation>die Sprache wurde gewechselt</translation>
    </message>
    <message>
        <source>the program did not answer for a while</source>
        <translation>das Programm antwortete eine Weile nicht</translation>
    </message>
    <message>
        <source>motors 1 and 2</source>
        <translation>Motoren 1 und 2</translation>
    </message>
    <message>
        <source>motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>motor 2</source>
        <translation>Motor 2</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>the port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>the controller</source>
        <translation>Controller</translation>
    </message>
    <message>
        <source>The controller refused: it has no such parameter</source>
        <translation>Der Controller hat abgelehnt: er hat keinen solchen Parameter</translation>
    </message>
    <message>
        <source>Check the parameter&apos;s number; 0x17 needs firmware 1.2 or later.</source>
        <translation>Nummer des Parameters prüfen; 0x17 erfordert Firmware 1.2 oder neuer.</translation>
    </message>
    <message>
        <source>The controller refused the value</source>
        <translation>Der Controller hat den Wert abgelehnt</translation>
    </message>
    <message>
        <source>Check its range; a calibration needs minimum ≤ neutral ≤ maximum and minimum &lt; maximum.</source>
        <translation>Bereich prüfen; eine Kalibrierung erfordert Minimum ≤ Neutral ≤ Maximum und Minimum &lt; Maximum.</translation>
    </message>
    <message>
        <source>The controller refused: it is not in serial mode</source>
        <translation>Der Controller hat abgelehnt: er ist nicht im seriellen Modus</translation>
    </message>
    <message>
        <source>Switch its power off, take the mode jumper off, switch it on and try again.</source>
        <translation>Ausschalten, Modus-Steckbrücke abziehen, einschalten und erneut versuchen.</translation>
    </message>
    <message>
        <source>The controller gave an answer that its documentation does not know</source>
        <translation>Der Controller gab eine Antwort, die seine Dokumentation nicht kennt</translation>
    </message>
    <message>
        <source>Read the value back to see whether it was stored.</source>
        <translation>Den Wert zurücklesen, um zu sehen, ob er gespeichert wurde.</translation>
    </message>
    <message>
        <source>No reply from %1</source>
        <translation>Keine Antwort: %1</translation>
    </message>
    <message>
        <source>Check its power, the wiring, baud rate, error detection and device number; Scan tries the settings for you.</source>
        <translation>Versorgung, Verdrahtung, Baudrate, Fehlererkennung und Gerätenummer prüfen; die Suche probiert die Einstellungen durch.</translation>
    </message>
    <message>
        <source>The reply broke off</source>
        <translation>Die Antwort ist abgebrochen</translation>
    </message>
    <message>
        <source>Check the wiring and the controller&apos;s power, then try again.</source>
        <translation>Verdrahtung und Versorgung des Controllers prüfen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>The reply failed its CRC check</source>
        <translation>Die CRC-Prüfung der Antwort ist fehlgeschlagen</translation>
    </message>
    <message>
        <source>Check the wiring for noise, and that the controller uses the same CRC-7 polynomial.</source>
        <translation>Verkabelung auf Störeinflüsse prüfen und ob der Controller dasselbe CRC-7-Polynom verwendet.</translation>
    </message>
    <message>
        <source>The reply makes no sense from a TReX</source>
        <translation>Die Antwort ist für einen TReX nicht plausibel</translation>
    </message>
    <message>
        <source>Check that a TReX or TReX Jr is connected, and its baud rate and error detection.</source>
        <translation>Prüfen, ob ein TReX oder TReX Jr angeschlossen ist, ferner Baudrate und Fehlererkennung.</translation>
    </message>
    <message>
        <source>The controller did not answer the setting, so it discarded the packet</source>
        <translation>Der Controller hat die Einstellung nicht beantwortet, das Paket also verworfen</translation>
    </message>
    <message>
        <source>Look at the UART error byte for the reason, then try again.</source>
        <translation>Die Ursache im UART-Fehlerbyte nachsehen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>Only our own bytes came back from %1</source>
        <translation>Nur die eigenen Bytes kamen zurück: %1</translation>
    </message>
    <message>
        <source>Check the controller&apos;s power and the wiring, that the RS-232 pins carry RS-232 and the SI and SO pins logic levels, and the baud rate.</source>
        <translation>Stromversorgung des Controllers und Verkabelung prüfen, ob die RS-232-Pins RS-232 und die Pins SI und SO Logikpegel führen, sowie die Baudrate.</translation>
    </message>
    <message>
        <source>Bytes came from %1 that are no reply of a TReX</source>
        <translation>Empfangene Bytes sind keine Antwort eines TReX: %1</translation>
    </message>
    <message>
        <source>Perhaps it uses another baud rate or error detection (Scan finds it), or another device is connected.</source>
        <translation>Vielleicht gilt eine andere Baudrate oder Fehlererkennung (die Suche findet sie), oder ein anderes Gerät ist angeschlossen.</translation>
    </message>
    <message>
        <source>Something answered, but not with the signature of a TReX</source>
        <translation>Etwas hat geantwortet, aber nicht mit der Signatur eines TReX</translation>
    </message>
    <message>
        <source>Choose another port, or another baud rate or device number.</source>
        <translation>Anderen Port, andere Baudrate oder andere Gerätenummer wählen.</translation>
    </message>
    <message>
        <source>The connection to %1 was lost</source>
        <translation>Verbindung verloren: %1</translation>
    </message>
    <message>
        <source>Check the cable and the adapter, then connect again.</source>
        <translation>Kabel und Adapter prüfen, dann neu verbinden.</translation>
    </message>
    <message>
        <source>There is no connection to a controller</source>
        <translation>Keine Verbindung zu einem Controller</translation>
    </message>
    <message>
        <source>Connect first.</source>
        <translation>Zuerst verbinden.</translation>
    </message>
    <message>
        <source>Cancelled on request</source>
        <translation>Auf Wunsch abgebrochen</translation>
    </message>
    <message>
        <source>There is no port %1</source>
        <translation>Es gibt keinen Port %1</translation>
    </message>
    <message>
        <source>Check that the adapter is plugged in, or choose another port.</source>
        <translation>Prüfen, ob der Adapter eingesteckt ist, oder einen anderen Port wählen.</translation>
    </message>
    <message>
        <source>of that name</source>
        <translation>dieses Namens</translation>
    </message>
    <message>
        <source>Another program uses %1</source>
        <translation>Von einem anderen Programm belegt: %1</translation>
    </message>
    <message>
        <source>Close that program, then try again.</source>
        <translation>Das andere Programm schließen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>No permission to open %1</source>
        <translation>Keine Berechtigung zum Öffnen: %1</translation>
    </message>
    <message>
        <source>Add yourself to the group dialout (sudo usermod -aG dialout $USER), then log in again.</source>
        <translation>Das eigene Konto in die Gruppe dialout aufnehmen (sudo usermod -aG dialout $USER), dann neu anmelden.</translation>
    </message>
    <message>
        <source>Not a serial port: %1</source>
        <translation>Kein serieller Port: %1</translation>
    </message>
    <message>
        <source>Choose a serial device such as /dev/ttyUSB0 or COM3, a tcp://HOST:PORT address, or sim: for the simulator.</source>
        <translation>Ein serielles Gerät wie /dev/ttyUSB0 oder COM3, eine Adresse tcp://HOST:PORT oder sim: für den Simulator wählen.</translation>
    </message>
    <message>
        <source>Could not open or set up %1</source>
        <translation>Öffnen oder Einrichten fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Check the address and the cable, plug the adapter in again, then retry.</source>
        <translation>Adresse und Kabel prüfen, Adapter neu einstecken, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>Not a port address: %1</source>
        <translation>Keine Portadresse: %1</translation>
    </message>
    <message>
        <source>Give a serial device such as /dev/ttyUSB0 or COM3, tcp://HOST:PORT, or sim: for the simulator.</source>
        <translation>Ein serielles Gerät wie /dev/ttyUSB0 oder COM3, tcp://HOST:PORT oder sim: für den Simulator angeben.</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>Out of range: %1</source>
        <translation>Außerhalb des Bereichs: %1</translation>
    </message>
    <message>
        <source>Nothing was sent; give a value within the range.</source>
        <translation>Nichts wurde gesendet; einen Wert innerhalb des Bereichs angeben.</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>Not a command of the TReX: %1</source>
        <translation>Kein Befehl des TReX: %1</translation>
    </message>
    <message>
        <source>Nothing was sent; check the command and its data bytes.</source>
        <translation>Nichts wurde gesendet; Befehl und Datenbytes prüfen.</translation>
    </message>
    <message>
        <source>no bytes</source>
        <translation>keine Bytes</translation>
    </message>
    <message>
        <source>The motors are not armed</source>
        <translation>Die Motoren sind nicht scharf geschaltet</translation>
    </message>
    <message>
        <source>Nothing was sent; arm them in the Motors panel first.</source>
        <translation>Nichts wurde gesendet; zuerst im Bereich Motoren scharf schalten.</translation>
    </message>
    <message>
        <source>The motors are locked while another task runs</source>
        <translation>Die Motoren sind gesperrt, solange ein anderer Vorgang läuft</translation>
    </message>
    <message>
        <source>Nothing was sent; finish or cancel that task first.</source>
        <translation>Nichts wurde gesendet; zuerst den anderen Vorgang beenden oder abbrechen.</translation>
    </message>
    <message>
        <source>Not available in joint motor mode</source>
        <translation>Im gemeinsamen Motormodus nicht verfügbar</translation>
    </message>
    <message>
        <source>Both H-bridges drive one motor there, without current readings; the motor mode parameter changes that.</source>
        <translation>Beide H-Brücken treiben dort einen Motor, ohne Strommesswerte; der Parameter Motormodus ändert das.</translation>
    </message>
    <message>
        <source>What was read back differs from what was written</source>
        <translation>Zurückgelesenes weicht vom Geschriebenen ab</translation>
    </message>
    <message>
        <source>Read the value again, and write it once more if it is still wrong.</source>
        <translation>Den Wert erneut lesen und noch einmal schreiben, falls er weiterhin falsch ist.</translation>
    </message>
    <message>
        <source>Could not read %1</source>
        <translation>Lesen fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Check its name, and that you may read it.</source>
        <translation>Namen und Leseberechtigung prüfen.</translation>
    </message>
    <message>
        <source>The file makes no sense</source>
        <translation>Der Inhalt der Datei ist fehlerhaft</translation>
    </message>
    <message>
        <source>Correct that place, or choose another file.</source>
        <translation>Die Stelle korrigieren oder eine andere Datei wählen.</translation>
    </message>
    <message>
        <source>Could not write %1</source>
        <translation>Schreiben fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Check its folder, that you may write there, and that the disk is not full.</source>
        <translation>Ordner und Schreibberechtigung prüfen und ob der Datenträger voll ist.</translation>
    </message>
    <message>
        <source>This is a recording: nothing here reaches a controller</source>
        <translation>Dies ist eine Aufzeichnung: Nichts von hier erreicht einen Controller</translation>
    </message>
    <message>
        <source>Use the window of the controller that is connected.</source>
        <translation>Verwenden Sie das Fenster des verbundenen Controllers.</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>Prozess %1</translation>
    </message>
    <message>
        <source>%1, process %2</source>
        <translation>%1, Prozess %2</translation>
    </message>
</context>
<context>
    <name>JournalText</name>
    <message>
        <source>%1, found out later</source>
        <translation>%1, später festgestellt</translation>
    </message>
    <message>
        <source>factory defaults</source>
        <translation>Werkseinstellungen</translation>
    </message>
    <message>
        <source>read back as written</source>
        <translation>zurückgelesen wie geschrieben</translation>
    </message>
    <message>
        <source>not written: the old value holds</source>
        <translation>nicht geschrieben: der alte Wert gilt</translation>
    </message>
    <message>
        <source>another value holds: %1</source>
        <translation>ein anderer Wert gilt: %1</translation>
    </message>
    <message>
        <source>accepted, not read back</source>
        <translation>angenommen, nicht zurückgelesen</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>abgelehnt: %1</translation>
    </message>
    <message>
        <source>not known, cannot be read back</source>
        <translation>unbekannt, nicht zurücklesbar</translation>
    </message>
    <message>
        <source>not known: will be read back when this controller is connected</source>
        <translation>unbekannt: wird zurückgelesen, sobald dieser Controller verbunden ist</translation>
    </message>
    <message>
        <source>The journal %1 is damaged: it is kept as %1.damaged, and a new one is begun.</source>
        <translation>Das Journal %1 ist beschädigt: Es wird als %1.damaged aufbewahrt und ein neues begonnen.</translation>
    </message>
    <message>
        <source>the journal %1 (%2)</source>
        <translation>Journal %1 (%2)</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for SQLite is not installed</source>
        <translation>der Qt-Treiber für SQLite ist nicht installiert</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>es ist keine Datei</translation>
    </message>
    <message>
        <source>its folder cannot be made</source>
        <translation>sein Ordner kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>another program holds it</source>
        <translation>ein anderes Programm hält es belegt</translation>
    </message>
    <message>
        <source>the journal %1 (it belongs to a newer version of this program and stays as it is)</source>
        <translation>Journal %1 (es gehört zu einer neueren Version dieses Programms und bleibt, wie es ist)</translation>
    </message>
    <message>
        <source>the journal %1 (it is damaged)</source>
        <translation>Journal %1 (es ist beschädigt)</translation>
    </message>
    <message>
        <source>a checkpoint named %1 is there already</source>
        <translation>ein Sicherungspunkt namens %1 ist bereits vorhanden</translation>
    </message>
    <message>
        <source>journal entry %1</source>
        <translation>Journaleintrag %1</translation>
    </message>
    <message>
        <source>no checkpoint is named %1</source>
        <translation>kein Sicherungspunkt heißt %1</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>es ist beschädigt</translation>
    </message>
    <message>
        <source>it may not be written</source>
        <translation>keine Schreibberechtigung</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>es lässt sich nicht öffnen</translation>
    </message>
</context>
<context>
    <name>LineText</name>
    <message>
        <source>%1 baud, no error detection</source>
        <translation>%1 Baud, ohne Fehlererkennung</translation>
    </message>
    <message>
        <source>%1 baud, even parity</source>
        <translation>%1 Baud, gerade Parität</translation>
    </message>
    <message>
        <source>%1 baud, odd parity</source>
        <translation>%1 Baud, ungerade Parität</translation>
    </message>
    <message>
        <source>%1 baud, CRC-7</source>
        <translation>%1 Baud, CRC-7</translation>
    </message>
    <message>
        <source>%1 with polynomial 0x%2</source>
        <translation>%1 mit Polynom 0x%2</translation>
    </message>
    <message>
        <source>%1, two stop bits</source>
        <translation>%1, zwei Stoppbits</translation>
    </message>
    <message>
        <source>Nothing at all came back. Check the controller&apos;s power, that ground and both data wires are connected, and that the two data wires are not swapped.</source>
        <translation>Es kam gar nichts zurück. Prüfen, ob der Controller versorgt ist und ob Masse und beide Datenleitungen angeschlossen und die beiden Datenleitungen nicht vertauscht sind.</translation>
    </message>
    <message>
        <source>Only our own bytes came back: the wiring reaches the RS-232 pins, but the controller does not answer. Check its power, and that an RS-232 adapter (not a logic-level one) is on those pins.</source>
        <translation>Nur die eigenen Bytes kamen zurück: Die Verkabelung reicht bis zu den RS-232-Pins, aber der Controller antwortet nicht. Seine Versorgung prüfen und ob ein RS-232-Adapter (keiner mit Logikpegeln) an diesen Pins liegt.</translation>
    </message>
    <message>
        <source>Only zeros came back: the data line is held low or inverted. A logic-level adapter belongs on SI and SO, an RS-232 adapter on the RS-232 pins; do not mix them.</source>
        <translation>Nur Nullen kamen zurück: Die Datenleitung wird auf Low gehalten oder ist invertiert. Ein Adapter mit Logikpegeln gehört an SI und SO, ein RS-232-Adapter an die RS-232-Pins; nicht vermischen.</translation>
    </message>
    <message>
        <source>Bytes came back that are no reply of a TReX. Check for a loose ground and for other devices on the line; with CRC-7, give its polynomial if it was changed.</source>
        <translation>Es kamen Bytes zurück, die keine Antwort eines TReX sind. Auf lose Masse und andere Geräte an der Leitung prüfen; bei CRC-7 das Polynom angeben, falls es geändert wurde.</translation>
    </message>
    <message>
        <source>Last resort, back to the factory&apos;s serial settings (19200 baud, no error detection):
1. Switch the controller off.
2. Take the mode jumper off.
3. Connect SO to ground with the learning jumper.
4. Put the mix jumper on.
5. Switch on: red and green blink in turn.
6. Take the mix jumper off: they blink faster. Go no further, taking the SO jumper off now enters the firmware upgrade.
7. Switch off, take the learning jumper off, switch on, and recover again.
The steps come from people who quote the vendor&apos;s guide; that they restore the serial settings is inferred, not confirmed.</source>
        <translation>Letzter Ausweg, zurück zu den seriellen Werkseinstellungen (19200 Baud, keine Fehlererkennung):
1. Den Regler ausschalten.
2. Den Modus-Jumper abziehen.
3. SO mit dem Lern-Jumper mit Masse verbinden.
4. Den Mix-Jumper aufstecken.
5. Einschalten: Rot und Grün blinken abwechselnd.
6. Den Mix-Jumper abziehen: sie blinken schneller. Nicht weitergehen; wer jetzt den SO-Jumper abzieht, beginnt die Firmware-Aktualisierung.
7. Ausschalten, den Lern-Jumper abziehen, einschalten und noch einmal wiederfinden lassen.
Die Schritte stammen von Leuten, die die Anleitung des Herstellers zitieren; dass sie die seriellen Einstellungen zurücksetzen, ist erschlossen, nicht bestätigt.</translation>
    </message>
    <message>
        <source>Not tried: %1, since a question there could be heard as a motor command at another speed; if these are the settings, switch the motor power off and connect with them.</source>
        <translation>Nicht versucht: %1, denn eine Frage dort könnte bei anderer Geschwindigkeit als Motorbefehl verstanden werden; sind dies die Einstellungen, schalten Sie die Motorversorgung aus und verbinden Sie damit.</translation>
    </message>
</context>
<context>
    <name>LinkAdvice</name>
    <message>
        <source>Not connected: there is nothing to judge. What figures there are stem from the time before.</source>
        <translation>Nicht verbunden: Es gibt nichts zu beurteilen. Vorhandene Zahlen stammen aus der Zeit davor.</translation>
    </message>
    <message>
        <source>Too early to judge: %1 of at least %2 answers so far.</source>
        <translation>Noch zu früh für ein Urteil: %1 von mindestens %2 Antworten bisher.</translation>
    </message>
    <message>
        <source>Times that the line was lost since the counting began: %1. A loose plug, a controller that browns out or an adapter without power does that: check plugs and supply. The log has the moments.</source>
        <translation>Verbindungsverluste seit Beginn der Zählung: %1. Ein lockerer Stecker, ein Controller mit Unterspannung oder ein Adapter ohne Versorgung tut das: Prüfen Sie Stecker und Versorgung. Das Protokoll nennt die Zeitpunkte.</translation>
    </message>
    <message>
        <source>Bytes that nobody had asked for came %1 times in the last minute (%2 bytes): another master talks on this line, or a second controller answers (inferred). Take the other master off; give each controller a number of its own and choose the Pololu protocol with that number.</source>
        <translation>%1-mal kamen in der letzten Minute Bytes, nach denen niemand gefragt hatte (%2 Bytes): Ein anderer Master spricht auf dieser Leitung, oder ein zweiter Controller antwortet mit (erschlossen). Trennen Sie den anderen Master; geben Sie jedem Controller eine eigene Nummer, und wählen Sie das Pololu-Protokoll mit dieser Nummer.</translation>
    </message>
    <message>
        <source>%1 of %2 answers came damaged in the last minute (%3 %). Without CRC-7 a damaged value of the right length goes unnoticed. Set error detection to CRC-7 in the UART settings, apply, and switch the controller off and on; the program follows. Then look for the cause: motor wires beside the cable, a missing ground.</source>
        <translation>%1 von %2 Antworten kamen in der letzten Minute beschädigt an (%3 %). Ohne CRC-7 bleibt ein beschädigter Wert der richtigen Länge unbemerkt. Stellen Sie die Fehlererkennung in den UART-Einstellungen auf CRC-7, übernehmen Sie sie und schalten Sie den Controller aus und ein; das Programm folgt. Suchen Sie dann die Ursache: Motorkabel neben der Leitung, eine fehlende Masse.</translation>
    </message>
    <message>
        <source>%1 of %2 answers came damaged in the last minute (%3 %); CRC-7 found them, and they were asked for again. Lead the cable away from the motor wires, connect the grounds, or choose a lower baud rate in the UART settings.</source>
        <translation>%1 von %2 Antworten kamen in der letzten Minute beschädigt an (%3 %); CRC-7 hat sie erkannt, und sie wurden neu erfragt. Führen Sie die Leitung nicht neben den Motorkabeln, verbinden Sie die Massen, oder wählen Sie in den UART-Einstellungen eine niedrigere Baudrate.</translation>
    </message>
    <message>
        <source>%1 of %2 questions got no answer within %3 ms in the last minute (%4 %): bytes are lost on the way, or the controller is off for moments. Check plugs, ground and supply. If answers only come later than that, give a longer reply timeout.</source>
        <translation>%1 von %2 Anfragen blieben in der letzten Minute %3 ms lang ohne Antwort (%4 %): Bytes gehen unterwegs verloren, oder der Controller ist kurzzeitig aus. Prüfen Sie Stecker, Masse und Versorgung. Kommen die Antworten nur später, verlängern Sie die Antwortfrist.</translation>
    </message>
    <message>
        <source>The controller reported a frame or parity error %1 times in the last minute: noise on the wire to it, or its speed, parity or stop bits are not quite ours.</source>
        <translation>Der Controller meldete in der letzten Minute %1-mal einen Rahmen- oder Paritätsfehler: Störungen auf der Leitung zu ihm, oder seine Baudrate, Parität oder Stoppbits sind nicht ganz die unseren.</translation>
    </message>
    <message>
        <source>The controller could not take bytes as fast as they came, %1 times in the last minute: set two stop bits or a lower baud rate in the UART settings.</source>
        <translation>Der Controller konnte Bytes nicht so schnell annehmen, wie sie kamen, %1-mal in der letzten Minute: Stellen Sie in den UART-Einstellungen zwei Stoppbits oder eine niedrigere Baudrate ein.</translation>
    </message>
    <message>
        <source>The controller got packets that it could not read or whose CRC was wrong, %1 times in the last minute: bytes are damaged on the way to it, or another master talks between ours.</source>
        <translation>Der Controller erhielt Pakete, die er nicht lesen konnte oder deren CRC falsch war, %1-mal in der letzten Minute: Bytes werden auf dem Weg zu ihm beschädigt, oder ein anderer Master spricht dazwischen.</translation>
    </message>
    <message>
        <source>The controller&apos;s answers piled up %1 times in the last minute. This program waits for each answer before it asks again: another master asks, too.</source>
        <translation>Die Antworten des Controllers stauten sich in der letzten Minute %1-mal. Dieses Programm wartet jede Antwort ab, bevor es wieder fragt: Ein anderer Master fragt ebenfalls.</translation>
    </message>
    <message>
        <source>The controller&apos;s serial timeout passed %1 times in the last minute: for that long nothing it could read reached it. If the line is otherwise well, give a longer serial timeout.</source>
        <translation>Die serielle Zeitüberwachung des Controllers lief in der letzten Minute %1-mal ab: So lange erreichte ihn nichts Lesbares. Ist die Leitung sonst in Ordnung, stellen Sie eine längere Zeit ein.</translation>
    </message>
    <message>
        <source>Answers came after the %1 ms that are waited for them, %2 times in the last minute; %3 ms are waited now. Give a reply timeout of at least %3 ms, or find what holds them back: a slow network, a busy computer, a wireless adapter.</source>
        <translation>Antworten kamen erst nach den %1 ms, die auf sie gewartet wird, %2-mal in der letzten Minute; jetzt wird %3 ms gewartet. Geben Sie eine Antwortfrist von mindestens %3 ms an, oder suchen Sie, was sie aufhält: ein langsames Netz, ein ausgelasteter Rechner, ein Funkadapter.</translation>
    </message>
    <message>
        <source>The adapter gathers bytes for up to %4 ms before it hands them on (its latency timer): half of the answers take more than %1 ms, where the wire needs %2 ms. This program may not set it. The command below sets 1 ms until the adapter is plugged in again; the udev rule 60-trexpanel.rules sets it for good.</source>
        <translation>Der Adapter sammelt Bytes bis zu %4 ms lang, bevor er sie weitergibt (Latenzzeit): Die Hälfte der Antworten braucht mehr als %1 ms, die Leitung allein %2 ms. Dieses Programm darf sie nicht stellen. Der Befehl unten stellt 1 ms ein, bis der Adapter neu eingesteckt wird; die udev-Regel 60-trexpanel.rules stellt sie dauerhaft.</translation>
    </message>
    <message>
        <source>Half of the answers take more than %1 ms, where the wire needs %2 ms: something holds them back for %3 ms. A USB adapter whose latency timer stands at 16 ms does that (inferred), so does a network or a busy computer: set the timer to 1 ms where the adapter is plugged in.</source>
        <translation>Die Hälfte der Antworten braucht mehr als %1 ms, die Leitung allein %2 ms: Etwas hält sie %3 ms lang auf. Ein USB-Adapter, dessen Latenzzeit auf 16 ms steht, tut das (erschlossen), ebenso ein Netz oder ein ausgelasteter Rechner: Stellen Sie die Latenzzeit dort auf 1 ms, wo der Adapter eingesteckt ist.</translation>
    </message>
    <message>
        <source>The panels ask for more than %1 baud carry: they get %2 % of their rates, and the wire is busy %3 % of the time. Set %4 baud in the UART settings, apply, and switch the controller off and on; the program follows.</source>
        <translation>Die Bereiche fragen mehr ab, als %1 Baud tragen: Sie bekommen %2 % ihrer Raten, und die Leitung ist %3 % der Zeit belegt. Stellen Sie in den UART-Einstellungen %4 Baud ein, übernehmen Sie sie und schalten Sie den Controller aus und ein; das Programm folgt.</translation>
    </message>
    <message>
        <source>The panels get %1 % of the rates that they ask for. The wire is busy %2 % of the time, the rest is waiting for the adapter, the controller or a busy computer: no higher baud rate would help much. Close panels that you do not need.</source>
        <translation>Die Bereiche bekommen %1 % der gewünschten Raten. Die Leitung ist %2 % der Zeit belegt, der Rest ist Warten auf den Adapter, den Controller oder einen ausgelasteten Rechner: Eine höhere Baudrate würde wenig helfen. Schließen Sie Bereiche, die Sie nicht brauchen.</translation>
    </message>
    <message>
        <source>The line echoes what is sent (RS-232 wiring). The echo is recognised and dropped; nothing needs to be done.</source>
        <translation>Die Leitung gibt Gesendetes als Echo zurück (RS-232-Verkabelung). Das Echo wird erkannt und verworfen; es ist nichts zu tun.</translation>
    </message>
    <message>
        <source>The line is well: %1 answers in the last minute, %2 damaged or missing; half of them within %3 ms, 99 of 100 within %4 ms. The wire alone needs %5 ms.</source>
        <translation>Die Leitung ist in Ordnung: %1 Antworten in der letzten Minute, %2 beschädigt oder ausgeblieben; die Hälfte innerhalb von %3 ms, 99 von 100 innerhalb von %4 ms. Die Leitung allein braucht %5 ms.</translation>
    </message>
    <message>
        <source>its driver</source>
        <translation>sein Treiber</translation>
    </message>
    <message>
        <source>The adapter was asked to hand bytes on at once (low latency); %1 does so.</source>
        <translation>Der Adapter wurde gebeten, Bytes sofort weiterzugeben (niedrige Latenz); %1 tut es.</translation>
    </message>
    <message>
        <source>The adapter was asked to hand bytes on at once (low latency); %1 did not permit it.</source>
        <translation>Der Adapter wurde gebeten, Bytes sofort weiterzugeben (niedrige Latenz); %1 hat es nicht erlaubt.</translation>
    </message>
    <message>
        <source>The adapter was asked to hand bytes on at once (low latency); %1 does not know of it.</source>
        <translation>Der Adapter wurde gebeten, Bytes sofort weiterzugeben (niedrige Latenz); %1 kennt das nicht.</translation>
    </message>
    <message>
        <source>Its latency timer stands at %1 ms.</source>
        <translation>Seine Latenzzeit steht auf %1 ms.</translation>
    </message>
</context>
<context>
    <name>LinkFigures</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>send buffer</source>
        <translation>Sendepuffer</translation>
    </message>
    <message>
        <source>read buffer</source>
        <translation>Empfangspuffer</translation>
    </message>
    <message>
        <source>parity</source>
        <translation>Parität</translation>
    </message>
    <message>
        <source>overrun</source>
        <translation>Überlauf</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>CRC</source>
        <translation>CRC</translation>
    </message>
    <message>
        <source>format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>timeout</source>
        <translation>Zeitüberschreitung</translation>
    </message>
    <message>
        <source>Answer, half within</source>
        <translation>Antwort, Hälfte in</translation>
    </message>
    <message>
        <source>Answer, 99 % within</source>
        <translation>Antwort, 99 % in</translation>
    </message>
    <message>
        <source>Answer, longest</source>
        <translation>Antwort, längste</translation>
    </message>
    <message>
        <source>Wire alone, half within</source>
        <translation>Leitung allein, Hälfte in</translation>
    </message>
    <message>
        <source>Transactions</source>
        <translation>Transaktionen</translation>
    </message>
    <message>
        <source>Transactions a second</source>
        <translation>Transaktionen je Sekunde</translation>
    </message>
    <message>
        <source>Asked again</source>
        <translation>Erneut gefragt</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Keine Antwort</translation>
    </message>
    <message>
        <source>Answer broke off</source>
        <translation>Antwort abgebrochen</translation>
    </message>
    <message>
        <source>CRC wrong</source>
        <translation>CRC falsch</translation>
    </message>
    <message>
        <source>Implausible answer</source>
        <translation>Antwort nicht plausibel</translation>
    </message>
    <message>
        <source>Answer too late</source>
        <translation>Antwort zu spät</translation>
    </message>
    <message>
        <source>Late bytes dropped</source>
        <translation>Späte Bytes verworfen</translation>
    </message>
    <message>
        <source>Unasked bytes dropped</source>
        <translation>Ungefragte Bytes verworfen</translation>
    </message>
    <message>
        <source>Synchronised anew</source>
        <translation>Neu synchronisiert</translation>
    </message>
    <message>
        <source>Line lost</source>
        <translation>Leitung verloren</translation>
    </message>
    <message>
        <source>Controller&apos;s UART errors</source>
        <translation>UART-Fehler des Controllers</translation>
    </message>
    <message>
        <source>network; the line is the serial server&apos;s</source>
        <translation>Netz; die Leitung gehört dem seriellen Server</translation>
    </message>
    <message>
        <source>simulator in this program</source>
        <translation>Simulator in diesem Programm</translation>
    </message>
    <message>
        <source>pseudo-terminal</source>
        <translation>Pseudoterminal</translation>
    </message>
    <message>
        <source>, latency timer %1 ms</source>
        <translation>, Latenzzeit %1 ms</translation>
    </message>
    <message>
        <source>asked for and granted</source>
        <translation>erbeten und gewährt</translation>
    </message>
    <message>
        <source>asked for and refused</source>
        <translation>erbeten und verweigert</translation>
    </message>
    <message>
        <source>asked for; the driver does not know it</source>
        <translation>erbeten; der Treiber kennt sie nicht</translation>
    </message>
    <message>
        <source>nothing to ask here</source>
        <translation>hier nichts zu erbitten</translation>
    </message>
    <message>
        <source>CRC-7</source>
        <translation>CRC-7</translation>
    </message>
    <message>
        <source>even parity</source>
        <translation>gerade Parität</translation>
    </message>
    <message>
        <source>odd parity</source>
        <translation>ungerade Parität</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>%1 ms, %2 ms longer since answers came late</source>
        <translation>%1 ms, und %2 ms länger, da Antworten spät kamen</translation>
    </message>
    <message>
        <source>Bytes a second</source>
        <translation>Bytes je Sekunde</translation>
    </message>
    <message>
        <source>Wire busy</source>
        <translation>Leitung belegt</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 baud</source>
        <translation>%1 Baud</translation>
    </message>
    <message>
        <source>Error detection</source>
        <translation>Fehlererkennung</translation>
    </message>
    <message>
        <source>Waits for an answer</source>
        <translation>Wartet auf Antwort</translation>
    </message>
    <message>
        <source>Echo</source>
        <translation>Echo</translation>
    </message>
    <message>
        <source>yes, dropped</source>
        <translation>ja, verworfen</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Adapter</source>
        <translation>Adapter</translation>
    </message>
    <message>
        <source>Low latency</source>
        <translation>Niedrige Latenz</translation>
    </message>
    <message>
        <source>Rate of %1</source>
        <translation>Rate: %1</translation>
    </message>
    <message>
        <source>%1 of %2 Hz</source>
        <translation>%1 von %2 Hz</translation>
    </message>
    <message>
        <source>Of the last minute, and since the counting began (%1 s):</source>
        <translation>In der letzten Minute und seit Beginn der Zählung (%1 s):</translation>
    </message>
</context>
<context>
    <name>Marks</name>
    <message>
        <source>Connected</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>Link lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>Disconnected</source>
        <translation>Getrennt</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf geschaltet</translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation>Entschärft</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Setting written</source>
        <translation>Einstellung geschrieben</translation>
    </message>
    <message>
        <source>Over current</source>
        <translation>Überstrom</translation>
    </message>
    <message>
        <source>Motor fault</source>
        <translation>Motorfehler</translation>
    </message>
    <message>
        <source>Serial timeout</source>
        <translation>Zeitüberschreitung</translation>
    </message>
    <message>
        <source>Line error</source>
        <translation>Leitungsfehler</translation>
    </message>
    <message>
        <source>Restarted</source>
        <translation>Neu gestartet</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
</context>
<context>
    <name>MotionReason</name>
    <message>
        <source>braking %1 %</source>
        <translation>bremst %1 %</translation>
    </message>
    <message>
        <source>at zero</source>
        <translation>auf null</translation>
    </message>
    <message>
        <source>forward %1 %</source>
        <translation>vorwärts %1 %</translation>
    </message>
    <message>
        <source>reverse %1 %</source>
        <translation>rückwärts %1 %</translation>
    </message>
    <message>
        <source>motor 1 %1, motor 2 %2, auxiliary %3</source>
        <translation>Motor 1 %1, Motor 2 %2, Hilfsmotor %3</translation>
    </message>
    <message>
        <source>Stopping: the stop is on its way to all three motors.</source>
        <translation>Anhalten: Der Stopp ist zu allen drei Motoren unterwegs.</translation>
    </message>
    <message>
        <source>The stop could NOT be confirmed: the motors may still run. Cut their power if they do.</source>
        <translation>Der Stopp ist NICHT bestätigt: Die Motoren können noch laufen. Trennen Sie dann ihre Versorgung.</translation>
    </message>
    <message>
        <source>Connecting to %1…</source>
        <translation>Verbindung zu %1 wird aufgebaut…</translation>
    </message>
    <message>
        <source>%1 Trying again.</source>
        <translation>%1 Neuer Versuch läuft.</translation>
    </message>
    <message>
        <source>%1 What the motors do now is not known. Trying again.</source>
        <translation>%1 Was die Motoren jetzt tun, ist nicht bekannt. Neuer Versuch läuft.</translation>
    </message>
    <message>
        <source>The link is lost: what the motors do now is not known. Trying again.</source>
        <translation>Die Verbindung ist verloren: Was die Motoren jetzt tun, ist unbekannt. Neuer Versuch läuft.</translation>
    </message>
    <message>
        <source>Not connected: connect to a controller, or simulate one.</source>
        <translation>Nicht verbunden: mit einem Controller verbinden oder einen simulieren.</translation>
    </message>
    <message>
        <source>The watchdog proof runs: nothing is sent on purpose. Esc stops.</source>
        <translation>Der Nachweis der Zeitüberwachung läuft: Es wird absichtlich nichts gesendet. Esc hält an.</translation>
    </message>
    <message>
        <source>Stall guard: a motor drew too much current for too long. All motors are led to zero.</source>
        <translation>Blockierschutz: Ein Motor zog zu lange zu viel Strom. Alle Motoren werden auf null geführt.</translation>
    </message>
    <message>
        <source>Stopped: all motors were told to stop. Arming is locked for half a second.</source>
        <translation>Angehalten: Alle Motoren haben den Stopp bekommen. Scharfschalten ist eine halbe Sekunde gesperrt.</translation>
    </message>
    <message>
        <source>Stopped: all motors were told to stop. Arm to drive again.</source>
        <translation>Gestoppt: Allen Motoren wurde Stopp befohlen. Zum Weiterfahren scharf schalten.</translation>
    </message>
    <message>
        <source>Motor %1: its driver reports a fault and has switched off. Look for a short circuit, heat or a weak supply.</source>
        <translation>Motor %1: Sein Treiber meldet einen Fehler und hat abgeschaltet. Prüfen Sie auf Kurzschluss, Hitze und zu schwache Versorgung.</translation>
    </message>
    <message>
        <source>Motors off: channel %1 is required and brings no valid pulse. Switch the transmitter on, or change the required channels.</source>
        <translation>Motoren aus: Kanal %1 ist erforderlich und bringt keinen gültigen Impuls. Schalten Sie den Sender ein, oder ändern Sie die erforderlichen Kanäle.</translation>
    </message>
    <message>
        <source>Serial override: channel 5 has given the motors to this program. Arm to drive, or switch channel 5 back.</source>
        <translation>Serieller Vorrang: Kanal 5 hat die Motoren diesem Programm gegeben. Zum Fahren scharf schalten, oder Kanal 5 zurückschalten.</translation>
    </message>
    <message>
        <source>Probably safe-start: channel %1 is not at neutral, and no motor draws current. Bring all motor channels to neutral (inferred).</source>
        <translation>Wahrscheinlich sicherer Start: Kanal %1 ist nicht neutral, und kein Motor zieht Strom. Bringen Sie alle Motorkanäle auf neutral (erschlossen).</translation>
    </message>
    <message>
        <source>Command pending: the channels control the motors now. It acts at the moment serial takes over.</source>
        <translation>Befehl wartet: Jetzt steuern die Kanäle die Motoren. Er wirkt, sobald die serielle Übernahme beginnt.</translation>
    </message>
    <message>
        <source>Armed, but the channels control the motors (mode jumper, channel 5): commands will wait in the controller.</source>
        <translation>Scharf, aber die Kanäle steuern die Motoren (Betriebsart-Brücke, Kanal 5): Befehle warten im Controller.</translation>
    </message>
    <message>
        <source>The channels drive the motors: motor 1 %1, motor 2 %2. They do not hear this program.</source>
        <translation>Die Kanäle treiben die Motoren: Motor 1 %1, Motor 2 %2. Auf dieses Programm hören sie nicht.</translation>
    </message>
    <message>
        <source>Disarmed. The controller is in RC or analog mode: its channels control the motors.</source>
        <translation>Gesichert. Der Controller ist im RC- oder Analogmodus: Seine Kanäle steuern die Motoren.</translation>
    </message>
    <message>
        <source>Motors off: the serial timeout has stopped them, nothing was heard for its time. Arm to drive again.</source>
        <translation>Motoren aus: Die serielle Zeitüberwachung hat sie angehalten, so lange war nichts zu hören. Zum Fahren wieder scharf schalten.</translation>
    </message>
    <message>
        <source>Motors off: the controller heard an error on the line and is set to stop for it. The next order drives again.</source>
        <translation>Motoren aus: Der Controller hörte einen Fehler auf der Leitung und ist so eingestellt, dass er dann anhält. Der nächste Befehl treibt wieder an.</translation>
    </message>
    <message>
        <source>Motor %1 is held back by its current limit.</source>
        <translation>Motor %1 wird von seiner Strombegrenzung zurückgehalten.</translation>
    </message>
    <message>
        <source>Motor %1 drew more current than its limit a moment ago.</source>
        <translation>Motor %1 zog eben mehr Strom als seine Grenze.</translation>
    </message>
    <message>
        <source>Disarmed: %1. Arm to drive again.</source>
        <translation>Gesichert: %1. Zum Fahren wieder scharf schalten.</translation>
    </message>
    <message>
        <source>Disarmed: nothing is sent to the motors. Arm to drive them.</source>
        <translation>Gesichert: An die Motoren wird nichts gesendet. Zum Antreiben scharf schalten.</translation>
    </message>
    <message>
        <source>Joint mode: both bridges follow motor 1. Orders to motor 2 do nothing.</source>
        <translation>Gemeinsamer Betrieb: Beide Brücken folgen Motor 1. Befehle an Motor 2 bewirken nichts.</translation>
    </message>
    <message>
        <source>Braking: %1.</source>
        <translation>Bremsen: %1.</translation>
    </message>
    <message>
        <source>Ramp: %1, on the way to the order.</source>
        <translation>Rampe: %1, auf dem Weg zum Befehl.</translation>
    </message>
    <message>
        <source>Ordered to move, but no motor draws current: probably none is connected, or their supply is off (inferred).</source>
        <translation>Befehl zum Fahren, aber kein Motor zieht Strom: Wahrscheinlich ist keiner angeschlossen, oder ihre Versorgung ist aus (erschlossen).</translation>
    </message>
    <message>
        <source>Driving: %1.</source>
        <translation>Angetrieben: %1.</translation>
    </message>
    <message>
        <source>Armed: move a slider to drive. Esc stops.</source>
        <translation>Scharf: zum Fahren einen Schieberegler bewegen. Esc hält an.</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>serial device, tcp://HOST:PORT, or sim: (built-in simulator); default: the last one used</source>
        <translation>serielles Gerät, tcp://HOST:PORT oder sim: (eingebauter Simulator); Standard: zuletzt verwendet</translation>
    </message>
    <message>
        <source>1200 to 115200, as set in the controller; default 19200</source>
        <translation>1200 bis 115200, wie im Controller eingestellt; Standard 19200</translation>
    </message>
    <message>
        <source>packet form: compact (default) or pololu</source>
        <translation>Paketform: compact (Standard) oder pololu</translation>
    </message>
    <message>
        <source>device number 0 to 127; implies --protocol pololu; default 7</source>
        <translation>Gerätenummer 0 bis 127; bedingt --protocol pololu; Standard 7</translation>
    </message>
    <message>
        <source>none (default), even, odd or crc7, as set in the controller</source>
        <translation>none (Standard), even, odd oder crc7, wie im Controller eingestellt</translation>
    </message>
    <message>
        <source>8-bit polynomial, top bit set; default 0x89</source>
        <translation>8-Bit-Polynom, oberstes Bit gesetzt; Standard 0x89</translation>
    </message>
    <message>
        <source>1 (default) or 2</source>
        <translation>1 (Standard) oder 2</translation>
    </message>
    <message>
        <source>RS-232 wiring echoes what is sent: auto (default), on or off</source>
        <translation>RS-232-Verkabelung gibt Gesendetes als Echo zurück: auto (Standard), on oder off</translation>
    </message>
    <message>
        <source>wait for a reply, above its time on the wire; default 100</source>
        <translation>Wartezeit auf eine Antwort, über die Übertragungszeit hinaus; Standard 100</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos; (one of %3)</source>
        <translation>%1 &apos;%2&apos; (eines von %3)</translation>
    </message>
    <message>
        <source>--device with --protocol compact, which carries no number</source>
        <translation>--device mit --protocol compact, das keine Nummer überträgt</translation>
    </message>
    <message>
        <source>Line options</source>
        <translation>Leitungsoptionen</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos; is not a whole number (%3…%4)</source>
        <translation>%1 &apos;%2&apos; ist keine ganze Zahl (%3…%4)</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos; (a number above 0, at most %3)</source>
        <translation>%1 &apos;%2&apos; (eine Zahl über 0, höchstens %3)</translation>
    </message>
    <message>
        <source>--scale &apos;%1&apos; (50 to 400 percent)</source>
        <translation>--scale &apos;%1&apos; (50 bis 400 Prozent)</translation>
    </message>
    <message>
        <source>--theme &apos;%1&apos; (one of %2)</source>
        <translation>--theme &apos;%1&apos; (eines von %2)</translation>
    </message>
    <message>
        <source>--language &apos;%1&apos; (one of %2)</source>
        <translation>--language &apos;%1&apos; (eines von %2)</translation>
    </message>
    <message>
        <source>--simulate and --port: one or the other</source>
        <translation>--simulate und --port: nur eines von beiden</translation>
    </message>
    <message>
        <source>--report and --screenshots need --script</source>
        <translation>--report und --screenshots erfordern --script</translation>
    </message>
    <message>
        <source>Control panel for the Pololu TReX Jr motor controller.</source>
        <translation>Bedienfeld für den Motorcontroller Pololu TReX Jr.</translation>
    </message>
    <message>
        <source>connect to the built-in simulated controller</source>
        <translation>mit dem eingebauten simulierten Controller verbinden</translation>
    </message>
    <message>
        <source>needs no display</source>
        <translation>benötigt keine Anzeige</translation>
    </message>
    <message>
        <source>play this script, then exit: 0 passed, 1 a step failed, 2 unreadable</source>
        <translation>dieses Skript abspielen, dann beenden: 0 bestanden, 1 ein Schritt fehlgeschlagen, 2 unlesbar</translation>
    </message>
    <message>
        <source>write what the script did, as JSON</source>
        <translation>aufschreiben, was das Skript getan hat, als JSON</translation>
    </message>
    <message>
        <source>folder for the script&apos;s pictures; default out/demo</source>
        <translation>Ordner für die Bilder des Skripts; Standard out/demo</translation>
    </message>
    <message>
        <source>settings file in place of your own</source>
        <translation>Einstellungsdatei anstelle der eigenen</translation>
    </message>
    <message>
        <source>language, such as en or de</source>
        <translation>Sprache, etwa en oder de</translation>
    </message>
    <message>
        <source>light, dark or system</source>
        <translation>light, dark oder system</translation>
    </message>
    <message>
        <source>size of everything in percent, 50 to 400</source>
        <translation>Größe von allem in Prozent, 50 bis 400</translation>
    </message>
    <message>
        <source>log transactions to stderr; -vv the bytes, too</source>
        <translation>Transaktionen auf stderr protokollieren; -vv auch die Bytes</translation>
    </message>
    <message>
        <source>trexpanel: %1. See: trexpanel --help</source>
        <translation>trexpanel: %1. Siehe: trexpanel --help</translation>
    </message>
    <message>
        <source>a recording to open beside the panel</source>
        <translation>eine Aufzeichnung, die neben dem Panel geöffnet wird</translation>
    </message>
    <message>
        <source>there is no display</source>
        <translation>es gibt keine Anzeige</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 antwortet nicht</translation>
    </message>
    <message>
        <source>trexpanel: no window can be shown: %1. Start it in a graphical session, or with --offscreen, which needs no display.</source>
        <translation>trexpanel: Es kann kein Fenster gezeigt werden: %1. Starten Sie es in einer grafischen Sitzung, oder mit --offscreen, das keine Anzeige braucht.</translation>
    </message>
    <message>
        <source>trexpanel: no font is installed, so that nothing could be read. Install one (fonts-dejavu-core on Debian), or see to fontconfig&apos;s configuration.</source>
        <translation>trexpanel: Es ist keine Schrift installiert, sodass nichts zu lesen wäre. Installieren Sie eine (fonts-dejavu-core unter Debian), oder sehen Sie nach der Konfiguration von fontconfig.</translation>
    </message>
</context>
<context>
    <name>Packets</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 reverse %2</source>
        <translation>%1 rückwärts %2</translation>
    </message>
    <message>
        <source>%1 forward %2</source>
        <translation>%1 vorwärts %2</translation>
    </message>
    <message>
        <source>%1 brake %2</source>
        <translation>%1 bremsen %2</translation>
    </message>
    <message>
        <source>Set motors %1, %2</source>
        <translation>Motoren setzen: %1, %2</translation>
    </message>
    <message>
        <source>Accelerate motors %1, %2</source>
        <translation>Motoren beschleunigen: %1, %2</translation>
    </message>
    <message>
        <source>Brake motor 1, duty %1</source>
        <translation>Motor 1 bremsen, Bremsgrad %1</translation>
    </message>
    <message>
        <source>Brake motor 2, duty %1</source>
        <translation>Motor 2 bremsen, Bremsgrad %1</translation>
    </message>
    <message>
        <source>Get parameter %1</source>
        <translation>Parameter %1 lesen</translation>
    </message>
    <message>
        <source>Get calibration of channel %1</source>
        <translation>Kalibrierung von Kanal %1 lesen</translation>
    </message>
    <message>
        <source>Set parameter %1 to %2</source>
        <translation>Parameter %1 auf %2 setzen</translation>
    </message>
    <message>
        <source>Set calibration of channel %1: %2</source>
        <translation>Kalibrierung von Kanal %1 setzen: %2</translation>
    </message>
    <message>
        <source>invalid</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>unknown mode</source>
        <translation>unbekannter Modus</translation>
    </message>
    <message>
        <source>RC mode</source>
        <translation>RC-Modus</translation>
    </message>
    <message>
        <source>analog mode</source>
        <translation>Analogmodus</translation>
    </message>
    <message>
        <source>serial mode, RC inputs</source>
        <translation>serieller Modus, RC-Eingänge</translation>
    </message>
    <message>
        <source>serial mode, analog inputs</source>
        <translation>serieller Modus, Analogeingänge</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>Unknown command %1</source>
        <translation>Unbekannter Befehl %1</translation>
    </message>
    <message>
        <source>%1, malformed: %2</source>
        <translation>%1, fehlerhaft: %2</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>channel 1</source>
        <translation>Kanal 1</translation>
    </message>
    <message>
        <source>channel 2</source>
        <translation>Kanal 2</translation>
    </message>
    <message>
        <source>channel 3</source>
        <translation>Kanal 3</translation>
    </message>
    <message>
        <source>channel 4</source>
        <translation>Kanal 4</translation>
    </message>
    <message>
        <source>channel 5</source>
        <translation>Kanal 5</translation>
    </message>
    <message>
        <source>CRC error</source>
        <translation>CRC-Fehler</translation>
    </message>
    <message>
        <source>deadband</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>device number</source>
        <translation>Gerätenummer</translation>
    </message>
    <message>
        <source>format error</source>
        <translation>Formatfehler</translation>
    </message>
    <message>
        <source>format byte 1</source>
        <translation>Formatbyte 1</translation>
    </message>
    <message>
        <source>format byte 2</source>
        <translation>Formatbyte 2</translation>
    </message>
    <message>
        <source>frame error</source>
        <translation>Rahmenfehler</translation>
    </message>
    <message>
        <source>learned</source>
        <translation>gelernt</translation>
    </message>
    <message>
        <source>channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>motor 1 fault</source>
        <translation>Störung Motor 1</translation>
    </message>
    <message>
        <source>motor 1 over current limit</source>
        <translation>Überstrom Motor 1</translation>
    </message>
    <message>
        <source>motor 1 speed</source>
        <translation>Drehzahl Motor 1</translation>
    </message>
    <message>
        <source>motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>motor 2 fault</source>
        <translation>Störung Motor 2</translation>
    </message>
    <message>
        <source>motor 2 over current limit</source>
        <translation>Überstrom Motor 2</translation>
    </message>
    <message>
        <source>motor 2 speed</source>
        <translation>Drehzahl Motor 2</translation>
    </message>
    <message>
        <source>neutral</source>
        <translation>Neutral</translation>
    </message>
    <message>
        <source>data overrun</source>
        <translation>Datenüberlauf</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>parity error</source>
        <translation>Paritätsfehler</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>Rohwert</translation>
    </message>
    <message>
        <source>read buffer overrun</source>
        <translation>Lesepufferüberlauf</translation>
    </message>
    <message>
        <source>remapped</source>
        <translation>umgerechnet</translation>
    </message>
    <message>
        <source>send buffer overrun</source>
        <translation>Sendepufferüberlauf</translation>
    </message>
    <message>
        <source>serial controls the motors</source>
        <translation>Motoren seriell gesteuert</translation>
    </message>
    <message>
        <source>signature</source>
        <translation>Signatur</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>timeout</source>
        <translation>Zeitüberschreitung</translation>
    </message>
    <message>
        <source>UART error</source>
        <translation>UART-Fehler</translation>
    </message>
    <message>
        <source>UART errors</source>
        <translation>UART-Fehler</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>bit %1</source>
        <translation>Bit %1</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>refused: bad parameter number</source>
        <translation>abgelehnt: falsche Parameternummer</translation>
    </message>
    <message>
        <source>refused: bad value</source>
        <translation>abgelehnt: unzulässiger Wert</translation>
    </message>
    <message>
        <source>refused: not in serial mode</source>
        <translation>abgelehnt: nicht im seriellen Modus</translation>
    </message>
    <message>
        <source>unknown answer %1</source>
        <translation>unbekannte Antwort %1</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>Motor currents</source>
        <translation>Motorströme</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Packets</source>
        <translation>Pakete</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Bench tests</source>
        <translation>Prüfstand</translation>
    </message>
    <message>
        <source>Link health</source>
        <translation>Leitungsgüte</translation>
    </message>
</context>
<context>
    <name>ParameterField</name>
    <message>
        <source>no check</source>
        <translation>ohne Prüfung</translation>
    </message>
    <message>
        <source>even</source>
        <translation>gerade</translation>
    </message>
    <message>
        <source>odd</source>
        <translation>ungerade</translation>
    </message>
    <message>
        <source>CRC-7</source>
        <translation>CRC-7</translation>
    </message>
    <message>
        <source>1 stop</source>
        <translation>1 Stopp</translation>
    </message>
    <message>
        <source>2 stop</source>
        <translation>2 Stopp</translation>
    </message>
    <message>
        <source>baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>error detection</source>
        <translation>Fehlererkennung</translation>
    </message>
    <message>
        <source>stop bits</source>
        <translation>Stoppbits</translation>
    </message>
    <message>
        <source>The number as the controller stores it (raw)</source>
        <translation>Die Zahl, wie der Controller sie speichert (Rohwert)</translation>
    </message>
    <message>
        <source>1 motor 1 / turn</source>
        <translation>1 Motor 1 / Lenken</translation>
    </message>
    <message>
        <source>Channel 1: motor 1, or turning with the mix jumper on</source>
        <translation>Kanal 1: Motor 1 oder, mit Mix-Steckbrücke, Lenken</translation>
    </message>
    <message>
        <source>2 motor 2 / drive</source>
        <translation>2 Motor 2 / Fahren</translation>
    </message>
    <message>
        <source>Channel 2: motor 2, or forward and back with the mix jumper on</source>
        <translation>Kanal 2: Motor 2 oder, mit Mix-Steckbrücke, vor und zurück</translation>
    </message>
    <message>
        <source>3 auxiliary</source>
        <translation>3 Hilfsmotor</translation>
    </message>
    <message>
        <source>3 aux</source>
        <translation>3 Hilfsm.</translation>
    </message>
    <message>
        <source>Channel 3: speed of the auxiliary motor, one direction</source>
        <translation>Kanal 3: Drehzahl des Hilfsmotors, in einer Richtung</translation>
    </message>
    <message>
        <source>4 flip</source>
        <translation>4 Überkopf</translation>
    </message>
    <message>
        <source>Channel 4: flip switch, swaps motors and directions</source>
        <translation>Kanal 4: Überkopfschalter, tauscht Motoren und Richtungen</translation>
    </message>
    <message>
        <source>5 serial override</source>
        <translation>5 serielle Übernahme</translation>
    </message>
    <message>
        <source>5 serial</source>
        <translation>5 seriell</translation>
    </message>
    <message>
        <source>Channel 5: serial override, hands the motors to the serial line</source>
        <translation>Kanal 5: serielle Übernahme, übergibt die Motoren an die serielle Leitung</translation>
    </message>
    <message>
        <source>stored %1</source>
        <translation>gespeichert %1</translation>
    </message>
    <message>
        <source>1 M1</source>
        <translation>1 M1</translation>
    </message>
    <message>
        <source>2 M2</source>
        <translation>2 M2</translation>
    </message>
    <message>
        <source>M1</source>
        <translation>M1</translation>
    </message>
    <message>
        <source>M2</source>
        <translation>M2</translation>
    </message>
    <message>
        <source>aux</source>
        <translation>Hilfsm.</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>Überk.</translation>
    </message>
    <message>
        <source>serial</source>
        <translation>seriell</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
</context>
<context>
    <name>ParameterHelp</name>
    <message>
        <source> (Unsure: the vendor does not state it.)</source>
        <translation> (Unsicher: Der Hersteller gibt es nicht an.)</translation>
    </message>
    <message>
        <source>Range: %1. Default: %2, %3.</source>
        <translation>Bereich: %1. Standard: %2, %3.</translation>
    </message>
    <message>
        <source>Acts after a power cycle.</source>
        <translation>Wirkt nach Aus- und Einschalten.</translation>
    </message>
    <message>
        <source>Acts at once.</source>
        <translation>Wirkt sofort.</translation>
    </message>
    <message>
        <source>≈ The scale in amperes is inferred for the TReX.</source>
        <translation>≈ Die Skala in Ampere ist für den TReX gefolgert.</translation>
    </message>
    <message>
        <source>Meaning %1. Source: %2</source>
        <translation>Bedeutung %1. Quelle: %2</translation>
    </message>
</context>
<context>
    <name>ParameterText</name>
    <message>
        <source>%1 (unexpected)</source>
        <translation>%1 (unerwartet)</translation>
    </message>
    <message>
        <source>channels 1 to 5</source>
        <translation>Kanäle 1 bis 5</translation>
    </message>
    <message>
        <source>off, on</source>
        <translation>aus, ein</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>0x80 to 0xFF</source>
        <translation>0x80 bis 0xFF</translation>
    </message>
    <message>
        <source>1200 to 115200 baud</source>
        <translation>1200 bis 115200 Baud</translation>
    </message>
    <message>
        <source>documented</source>
        <translation>dokumentiert</translation>
    </message>
    <message>
        <source>observed on controllers</source>
        <translation>an Controllern beobachtet</translation>
    </message>
    <message>
        <source>inferred, quite sure</source>
        <translation>gefolgert, recht sicher</translation>
    </message>
    <message>
        <source>inferred, unsure</source>
        <translation>gefolgert, unsicher</translation>
    </message>
    <message>
        <source>a guess</source>
        <translation>vermutet</translation>
    </message>
    <message>
        <source>observed</source>
        <translation>beobachtet</translation>
    </message>
    <message>
        <source>quite sure</source>
        <translation>recht sicher</translation>
    </message>
    <message>
        <source>unsure</source>
        <translation>unsicher</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>no channel</source>
        <translation>kein Kanal</translation>
    </message>
    <message>
        <source>channel %1</source>
        <translation>Kanal %1</translation>
    </message>
    <message>
        <source>channels %1</source>
        <translation>Kanäle %1</translation>
    </message>
    <message>
        <source>even parity</source>
        <translation>gerade Parität</translation>
    </message>
    <message>
        <source>odd parity</source>
        <translation>ungerade Parität</translation>
    </message>
    <message>
        <source>CRC-7</source>
        <translation>CRC-7</translation>
    </message>
    <message>
        <source>no error detection</source>
        <translation>keine Fehlererkennung</translation>
    </message>
    <message>
        <source>%1: no such baud rate</source>
        <translation>%1: keine gültige Baudrate</translation>
    </message>
    <message>
        <source>%1 baud, %2, 1 stop bit</source>
        <translation>%1 Baud, %2, 1 Stoppbit</translation>
    </message>
    <message>
        <source>%1 baud, %2, 2 stop bits</source>
        <translation>%1 Baud, %2, 2 Stoppbits</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>independent</source>
        <translation>unabhängig</translation>
    </message>
    <message>
        <source>joint (one motor on both H-bridges)</source>
        <translation>gemeinsam (ein Motor an beiden H-Brücken)</translation>
    </message>
    <message>
        <source>RC pulses</source>
        <translation>RC-Impulse</translation>
    </message>
    <message>
        <source>analog voltages</source>
        <translation>Analogspannungen</translation>
    </message>
    <message>
        <source>0: 19.5 kHz</source>
        <translation>0: 19.5 kHz</translation>
    </message>
    <message>
        <source>1: 2.4 kHz</source>
        <translation>1: 2.4 kHz</translation>
    </message>
    <message>
        <source>2: about 610 Hz (unsure)</source>
        <translation>2: etwa 610 Hz (unsicher)</translation>
    </message>
    <message>
        <source>3: about 150 Hz (unsure)</source>
        <translation>3: etwa 150 Hz (unsicher)</translation>
    </message>
    <message>
        <source>Serial line and safety</source>
        <translation>Serielle Leitung und Sicherheit</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>Current limits</source>
        <translation>Stromgrenzen</translation>
    </message>
    <message>
        <source>Device number</source>
        <translation>Gerätenummer</translation>
    </message>
    <message>
        <source>The number this controller listens to in Pololu packets. Give each controller on a shared line its own.</source>
        <translation>Die Nummer, auf die dieser Controller in Pololu-Paketen hört. Jedem Controller an einer gemeinsamen Leitung eine eigene geben.</translation>
    </message>
    <message>
        <source>Required channels</source>
        <translation>Erforderliche Kanäle</translation>
    </message>
    <message>
        <source>RC mode: these channels must carry valid pulses before motors run; losing one for 500 ms stops them.</source>
        <translation>RC-Modus: Diese Kanäle müssen gültige Impulse führen, bevor Motoren laufen; fällt einer 500 ms lang aus, halten sie an.</translation>
    </message>
    <message>
        <source>Ignored channels</source>
        <translation>Ignorierte Kanäle</translation>
    </message>
    <message>
        <source>These channels count as resting at neutral, whatever their pins show.</source>
        <translation>Diese Kanäle gelten als in Neutralstellung ruhend, was immer an ihren Pins anliegt.</translation>
    </message>
    <message>
        <source>Reversed channels</source>
        <translation>Umgekehrte Kanäle</translation>
    </message>
    <message>
        <source>Forward and reverse change places on these channels.</source>
        <translation>Auf diesen Kanälen sind vorwärts und rückwärts vertauscht.</translation>
    </message>
    <message>
        <source>Parabolic channels</source>
        <translation>Parabolische Kanäle</translation>
    </message>
    <message>
        <source>Square-law response: finer control near neutral on these channels.</source>
        <translation>Quadratische Kennlinie: feinere Steuerung nahe Neutral auf diesen Kanälen.</translation>
    </message>
    <message>
        <source>Motor 1 deadband brake</source>
        <translation>Totbandbremse Motor 1</translation>
    </message>
    <message>
        <source>Braking duty while motor 1&apos;s channel rests in its deadband (RC and analog modes): 0 coasts, 127 brakes fully.</source>
        <translation>Bremsgrad, solange der Kanal von Motor 1 in seinem Totband ruht (RC- und Analogmodus): 0 lässt auslaufen, 127 bremst voll.</translation>
    </message>
    <message>
        <source>Motor 2 deadband brake</source>
        <translation>Totbandbremse Motor 2</translation>
    </message>
    <message>
        <source>Braking duty while motor 2&apos;s channel rests in its deadband (RC and analog modes): 0 coasts, 127 brakes fully.</source>
        <translation>Bremsgrad, solange der Kanal von Motor 2 in seinem Totband ruht (RC- und Analogmodus): 0 lässt auslaufen, 127 bremst voll.</translation>
    </message>
    <message>
        <source>Serial timeout</source>
        <translation>Serielle Zeitüberwachung</translation>
    </message>
    <message>
        <source>Motors stop when the controller hears nothing for this long. 0 switches the protection off.</source>
        <translation>Die Motoren halten an, wenn der Controller so lange nichts empfängt. 0 schaltet den Schutz aus.</translation>
    </message>
    <message>
        <source>Stop on UART error</source>
        <translation>Halt bei UART-Fehler</translation>
    </message>
    <message>
        <source>Any serial error stops the motors; the controller keeps listening.</source>
        <translation>Jeder serielle Fehler hält die Motoren an; der Controller empfängt weiter.</translation>
    </message>
    <message>
        <source>Motor 1 PWM prescaler</source>
        <translation>PWM-Vorteiler Motor 1</translation>
    </message>
    <message>
        <source>Sets motor 1&apos;s PWM frequency. The TReX Jr&apos;s driver is rated for 10 kHz.</source>
        <translation>Legt die PWM-Frequenz von Motor 1 fest. Der Treiber des TReX Jr ist für 10 kHz ausgelegt.</translation>
    </message>
    <message>
        <source>Motor 2 PWM prescaler</source>
        <translation>PWM-Vorteiler Motor 2</translation>
    </message>
    <message>
        <source>Sets motor 2&apos;s PWM frequency. The TReX Jr&apos;s driver is rated for 10 kHz.</source>
        <translation>Legt die PWM-Frequenz von Motor 2 fest. Der Treiber des TReX Jr ist für 10 kHz ausgelegt.</translation>
    </message>
    <message>
        <source>Motor 1 PWM maximum</source>
        <translation>PWM-Maximum Motor 1</translation>
    </message>
    <message>
        <source>Full scale of motor 1&apos;s speed number; 127 is the default 7-bit resolution.</source>
        <translation>Endwert der Drehzahlangabe von Motor 1; 127 ist die Standardauflösung von 7 Bit.</translation>
    </message>
    <message>
        <source>Motor 2 PWM maximum</source>
        <translation>PWM-Maximum Motor 2</translation>
    </message>
    <message>
        <source>Full scale of motor 2&apos;s speed number; 127 is the default 7-bit resolution.</source>
        <translation>Endwert der Drehzahlangabe von Motor 2; 127 ist die Standardauflösung von 7 Bit.</translation>
    </message>
    <message>
        <source>Auxiliary motor PWM maximum</source>
        <translation>PWM-Maximum Hilfsmotor</translation>
    </message>
    <message>
        <source>Full scale of the auxiliary motor&apos;s speed number.</source>
        <translation>Endwert der Drehzahlangabe des Hilfsmotors.</translation>
    </message>
    <message>
        <source>Motor 1 acceleration</source>
        <translation>Beschleunigung Motor 1</translation>
    </message>
    <message>
        <source>Speed steps gained every 100 ms by accelerate commands; 0 is unlimited.</source>
        <translation>Drehzahlschritte je 100 ms bei Beschleunigungsbefehlen; 0 ist unbegrenzt.</translation>
    </message>
    <message>
        <source>Motor 2 acceleration</source>
        <translation>Beschleunigung Motor 2</translation>
    </message>
    <message>
        <source>Auxiliary motor acceleration</source>
        <translation>Beschleunigung Hilfsmotor</translation>
    </message>
    <message>
        <source>Motor 1 brake duration</source>
        <translation>Bremsdauer Motor 1</translation>
    </message>
    <message>
        <source>Full braking before an accelerate command reverses motor 1.</source>
        <translation>Volles Bremsen, bevor ein Beschleunigungsbefehl die Richtung von Motor 1 umkehrt.</translation>
    </message>
    <message>
        <source>Motor 2 brake duration</source>
        <translation>Bremsdauer Motor 2</translation>
    </message>
    <message>
        <source>Full braking before an accelerate command reverses motor 2.</source>
        <translation>Volles Bremsen, bevor ein Beschleunigungsbefehl die Richtung von Motor 2 umkehrt.</translation>
    </message>
    <message>
        <source>Motor 1 current limit</source>
        <translation>Stromgrenze Motor 1</translation>
    </message>
    <message>
        <source>Motor 1 is slowed above this current; accelerate commands only. 0 is probably no limit.</source>
        <translation>Oberhalb dieses Stroms wird Motor 1 verlangsamt; nur bei Beschleunigungsbefehlen. 0 bedeutet vermutlich keine Grenze.</translation>
    </message>
    <message>
        <source>Motor 2 current limit</source>
        <translation>Stromgrenze Motor 2</translation>
    </message>
    <message>
        <source>Motor 2 is slowed above this current; accelerate commands only. 0 is probably no limit.</source>
        <translation>Oberhalb dieses Stroms wird Motor 2 verlangsamt; nur bei Beschleunigungsbefehlen. 0 bedeutet vermutlich keine Grenze.</translation>
    </message>
    <message>
        <source>Motor 1 current limit gain</source>
        <translation>Verstärkung Stromgrenze Motor 1</translation>
    </message>
    <message>
        <source>How hard the speed is cut back for each unit of excess current (proportionality constant P).</source>
        <translation>Wie stark die Drehzahl je Einheit Überstrom zurückgenommen wird (Proportionalitätskonstante P).</translation>
    </message>
    <message>
        <source>Motor 2 current limit gain</source>
        <translation>Verstärkung Stromgrenze Motor 2</translation>
    </message>
    <message>
        <source>Reply delay of 1 ms</source>
        <translation>Antwortverzögerung 1 ms</translation>
    </message>
    <message>
        <source>Waits 1 ms before each reply, for slow hosts. Firmware 1.2 and later.</source>
        <translation>Wartet vor jeder Antwort 1 ms, für langsame Gegenstellen. Ab Firmware 1.2.</translation>
    </message>
    <message>
        <source>Motor mode</source>
        <translation>Motormodus</translation>
    </message>
    <message>
        <source>Two motors, or one motor on both H-bridges. Joint mode has no current readings.</source>
        <translation>Zwei Motoren oder ein Motor an beiden H-Brücken. Im gemeinsamen Modus gibt es keine Strommesswerte.</translation>
    </message>
    <message>
        <source>Channel input source</source>
        <translation>Eingangsquelle der Kanäle</translation>
    </message>
    <message>
        <source>How the five inputs are read in serial mode.</source>
        <translation>Wie die fünf Eingänge im seriellen Modus gelesen werden.</translation>
    </message>
    <message>
        <source>CRC-7 polynomial</source>
        <translation>CRC-7-Polynom</translation>
    </message>
    <message>
        <source>Low seven bits of the CRC-7 polynomial; the top bit is always 1. 9 is the default 0x89.</source>
        <translation>Untere sieben Bits des CRC-7-Polynoms; das oberste Bit ist immer 1. 9 ist der Standard 0x89.</translation>
    </message>
    <message>
        <source>UART settings</source>
        <translation>UART-Einstellungen</translation>
    </message>
    <message>
        <source>Baud rate, error detection and stop bits of the serial line, in one byte.</source>
        <translation>Baudrate, Fehlererkennung und Stoppbits der seriellen Leitung in einem Byte.</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Alle Parameter zurücksetzen</translation>
    </message>
    <message>
        <source>Puts all parameters back to factory defaults. Calibrations stay.</source>
        <translation>Setzt alle Parameter auf Werkseinstellung zurück. Kalibrierungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>unlimited</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>no limit (unsure)</source>
        <translation>keine Grenze (unsicher)</translation>
    </message>
</context>
<context>
    <name>PlotView</name>
    <message>
        <source>no data</source>
        <translation>keine Daten</translation>
    </message>
    <message>
        <source>Arrow keys pan, plus and minus zoom, with Ctrl the values; Home shows the start, End follows the newest, F shows everything, P pauses. Alt with left and right goes back and forward through the views. 1 and 2 place the cursors, Shift with left and right moves one, Delete removes it. N and Shift N go to the next and the previous event.</source>
        <translation>Pfeiltasten verschieben, Plus und Minus zoomen, mit Strg die Werte; Pos1 zeigt den Anfang, Ende folgt dem Neuesten, F zeigt alles, P hält an. Alt mit links und rechts geht durch die Ansichten zurück und vor. 1 und 2 setzen die Cursor, Umschalt mit links und rechts bewegt einen, Entf entfernt ihn. N und Umschalt+N gehen zum nächsten und zum vorigen Ereignis.</translation>
    </message>
    <message>
        <source>limit 1: %1</source>
        <translation>Grenze 1: %1</translation>
    </message>
    <message>
        <source>limit 2: %1</source>
        <translation>Grenze 2: %1</translation>
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>%1 current</source>
        <translation>%1, Strom</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Teal</source>
        <translation>Türkis</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violett</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>Rosa</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Ochre</source>
        <translation>Ocker</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Black or white</source>
        <translation>Schwarz oder Weiß</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Dünn</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Thick</source>
        <translation>Dick</translation>
    </message>
</context>
<context>
    <name>Polls</name>
    <message>
        <source>currents</source>
        <translation>Ströme</translation>
    </message>
    <message>
        <source>channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>remapped channels</source>
        <translation>umgerechnete Kanäle</translation>
    </message>
    <message>
        <source>status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>UART errors</source>
        <translation>UART-Fehler</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>learned channels</source>
        <translation>gelernte Kanäle</translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>not a plain file</source>
        <translation>keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>not a recording</source>
        <translation>keine Aufzeichnung</translation>
    </message>
    <message>
        <source>a recording of another version; a newer program may read it</source>
        <translation>eine Aufzeichnung anderer Version; ein neueres Programm kann sie vielleicht lesen</translation>
    </message>
    <message>
        <source>too damaged to be opened</source>
        <translation>zu stark beschädigt zum Öffnen</translation>
    </message>
    <message>
        <source>no room for a copy to repair</source>
        <translation>kein Platz für eine Kopie zur Reparatur</translation>
    </message>
    <message>
        <source>its tables are not a recording&apos;s</source>
        <translation>ihre Tabellen sind nicht die einer Aufzeichnung</translation>
    </message>
    <message numerus="yes">
        <source>The recording is damaged: %n parts are left out.</source>
        <translation>
            <numerusform>Die Aufzeichnung ist beschädigt: %n Teil ist ausgelassen.</numerusform>
            <numerusform>Die Aufzeichnung ist beschädigt: %n Teile sind ausgelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording holds streams that this program does not know.</source>
        <translation>Die Aufzeichnung enthält Datenströme, die dieses Programm nicht kennt.</translation>
    </message>
    <message>
        <source>The recording was not ended: its last moments may be missing.</source>
        <translation>Die Aufzeichnung wurde nicht beendet: Ihre letzten Augenblicke können fehlen.</translation>
    </message>
    <message>
        <source>The disk was too slow: %1 events or packets are missing.</source>
        <translation>Der Datenträger war zu langsam: %1 Ereignisse oder Pakete fehlen.</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>The settings file makes no sense (%1). It is kept as %2, and the settings begin anew.</source>
        <translation>Die Einstellungsdatei ergibt keinen Sinn (%1). Sie ist als %2 aufgehoben, und die Einstellungen beginnen von vorn.</translation>
    </message>
    <message>
        <source>Settings of this session are not kept.</source>
        <translation>Einstellungen dieser Sitzung werden nicht aufgehoben.</translation>
    </message>
</context>
<context>
    <name>Streams</name>
    <message>
        <source>Motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>Motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>Channel 1</source>
        <translation>Kanal 1</translation>
    </message>
    <message>
        <source>Channel 2</source>
        <translation>Kanal 2</translation>
    </message>
    <message>
        <source>Channel 3</source>
        <translation>Kanal 3</translation>
    </message>
    <message>
        <source>Channel 4</source>
        <translation>Kanal 4</translation>
    </message>
    <message>
        <source>Channel 5</source>
        <translation>Kanal 5</translation>
    </message>
    <message>
        <source>Channel 1 remapped</source>
        <translation>Kanal 1 umgerechnet</translation>
    </message>
    <message>
        <source>Channel 2 remapped</source>
        <translation>Kanal 2 umgerechnet</translation>
    </message>
    <message>
        <source>Channel 3 remapped</source>
        <translation>Kanal 3 umgerechnet</translation>
    </message>
    <message>
        <source>Channel 4 remapped</source>
        <translation>Kanal 4 umgerechnet</translation>
    </message>
    <message>
        <source>Channel 5 remapped</source>
        <translation>Kanal 5 umgerechnet</translation>
    </message>
    <message>
        <source>Status byte</source>
        <translation>Statusbyte</translation>
    </message>
    <message>
        <source>UART error byte</source>
        <translation>UART-Fehlerbyte</translation>
    </message>
    <message>
        <source>Motor 1 command</source>
        <translation>Vorgabe Motor 1</translation>
    </message>
    <message>
        <source>Motor 2 command</source>
        <translation>Vorgabe Motor 2</translation>
    </message>
    <message>
        <source>Auxiliary motor command</source>
        <translation>Vorgabe Hilfsmotor</translation>
    </message>
    <message>
        <source>Transactions</source>
        <translation>Transaktionen</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Umlaufzeit</translation>
    </message>
    <message>
        <source>Link errors</source>
        <translation>Verbindungsfehler</translation>
    </message>
</context>
<context>
    <name>Transfer</name>
    <message>
        <source>RC</source>
        <translation>RC</translation>
    </message>
    <message>
        <source>analog</source>
        <translation>Analog</translation>
    </message>
    <message>
        <source>Nothing had to be written.</source>
        <translation>Es war nichts zu schreiben.</translation>
    </message>
    <message>
        <source>%1 settings are written and read back.</source>
        <translation>%1 Einstellungen geschrieben und zurückgelesen.</translation>
    </message>
    <message>
        <source>Written and read back: %1.</source>
        <translation>Geschrieben und zurückgelesen: %1.</translation>
    </message>
    <message>
        <source>The %1 calibration is left out: the controller uses the %2 one now and takes no other.</source>
        <translation>Die %1-Kalibrierung wird ausgelassen: Der Controller verwendet derzeit die %2-Kalibrierung und nimmt keine andere an.</translation>
    </message>
    <message>
        <source>The %1 calibration is left out: it is not known which one the controller uses now.</source>
        <translation>Die %1-Kalibrierung wird ausgelassen: Es ist nicht bekannt, welche der Controller derzeit verwendet.</translation>
    </message>
    <message>
        <source>Calibration of channel %1 (%2)</source>
        <translation>Kalibrierung von Kanal %1 (%2)</translation>
    </message>
    <message>
        <source>Nothing is changed in the controller.</source>
        <translation>Im Controller ist nichts geändert.</translation>
    </message>
    <message>
        <source>Put back as before: %1.</source>
        <translation>Wiederhergestellt wie zuvor: %1.</translation>
    </message>
    <message>
        <source>Could not be put back, read them again: %1.</source>
        <translation>Nicht wiederhergestellt, erneut lesen: %1.</translation>
    </message>
    <message>
        <source>Switch the controller&apos;s power off and on for: %1.</source>
        <translation>Controller aus- und einschalten für: %1.</translation>
    </message>
    <message>
        <source>Whether it is changed is not known.</source>
        <translation>Ob es geändert ist, ist unbekannt.</translation>
    </message>
    <message>
        <source>Written before that, and in the controller now: %1.</source>
        <translation>Vorher geschrieben und jetzt im Controller: %1.</translation>
    </message>
</context>
<context>
    <name>WritePreview</name>
    <message>
        <source>Nothing to write.</source>
        <translation>Nichts zu schreiben.</translation>
    </message>
    <message>
        <source>Will be written: %1</source>
        <translation>Wird geschrieben: %1</translation>
    </message>
    <message>
        <source>Needs a power cycle afterwards: %1.</source>
        <translation>Aus- und Einschalten danach nötig: %1.</translation>
    </message>
    <message>
        <source>(▲ %1 notes below)</source>
        <translation>(▲ %1 Hinweise unten)</translation>
    </message>
    <message>
        <source>Will be written, %1 settings%2:</source>
        <translation>Geschrieben werden %1 Einstellungen%2:</translation>
    </message>
    <message>
        <source>(▲ 1 note below)</source>
        <translation>(▲ 1 Hinweis unten)</translation>
    </message>
</context>
<context>
    <name>trex::AboutDialog</name>
    <message>
        <source>&lt;p&gt;A control panel for the Pololu TReX Jr dual motor controller.&lt;/p&gt;&lt;p&gt;This is free software under the GNU General Public License, version 3 or later (GPL-3.0-or-later). It comes without any warranty.&lt;/p&gt;&lt;p&gt;Pololu and TReX are names of Pololu Corporation, which has no part in this program.&lt;/p&gt;&lt;p&gt;The icons are drawn for this program and under the same licence. It is built with:&lt;/p&gt;</source>
        <translation>&lt;p&gt;Ein Bedienfeld für den Doppelmotor-Controller Pololu TReX Jr.&lt;/p&gt;&lt;p&gt;Dies ist freie Software unter der GNU General Public License, Version 3 oder später (GPL-3.0-or-later). Sie kommt ohne jede Gewährleistung.&lt;/p&gt;&lt;p&gt;Pololu und TReX sind Namen der Pololu Corporation, die an diesem Programm nicht beteiligt ist.&lt;/p&gt;&lt;p&gt;Die Symbole sind für dieses Programm gezeichnet und stehen unter derselben Lizenz. Es ist gebaut mit:&lt;/p&gt;</translation>
    </message>
    <message>
        <source>About TReX Panel</source>
        <translation>Über TReX Panel</translation>
    </message>
    <message>
        <source>About and licences</source>
        <translation>Info und Lizenzen</translation>
    </message>
</context>
<context>
    <name>trex::AdviceList</name>
    <message>
        <source>Advice %1</source>
        <translation>Hinweis %1</translation>
    </message>
    <message>
        <source>Command for the superuser</source>
        <translation>Befehl für den Systemverwalter</translation>
    </message>
    <message>
        <source>Copy the command</source>
        <translation>Befehl kopieren</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>Zu %1</translation>
    </message>
</context>
<context>
    <name>trex::BenchChart</name>
    <message>
        <source>Motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>Motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>Aux</source>
        <translation>Hilfsmotor</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>measured; thin: predicted</source>
        <translation>gemessen; dünn: vorhergesagt</translation>
    </message>
    <message>
        <source>predicted by the dry run</source>
        <translation>vom Probelauf vorhergesagt</translation>
    </message>
    <message>
        <source>The dry run shows here what currents to expect.</source>
        <translation>Der Probelauf zeigt hier, welche Ströme zu erwarten sind.</translation>
    </message>
</context>
<context>
    <name>trex::BenchLimitsForm</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source> A</source>
        <translation> A</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>More than this in one motor stops everything</source>
        <translation>Mehr als das in einem Motor hält alles an</translation>
    </message>
    <message>
        <source>… for</source>
        <translation>… für</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>a single reading</source>
        <translation>ein einziger Messwert</translation>
    </message>
    <message>
        <source>How long the current may be above its limit</source>
        <translation>Wie lange der Strom über seiner Grenze liegen darf</translation>
    </message>
    <message>
        <source>Current × time</source>
        <translation>Strom × Zeit</translation>
    </message>
    <message>
        <source> A s</source>
        <translation> A s</translation>
    </message>
    <message>
        <source>More than this in one motor since the start stops everything</source>
        <translation>Mehr als das in einem Motor seit dem Beginn hält alles an</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>as planned</source>
        <translation>wie geplant</translation>
    </message>
    <message>
        <source>Longer than this stops everything</source>
        <translation>Länger als das hält alles an</translation>
    </message>
    <message>
        <source>Link errors</source>
        <translation>Verbindungsfehler</translation>
    </message>
    <message>
        <source>More replies lost or damaged than this stop everything</source>
        <translation>Mehr verlorene oder beschädigte Antworten halten alles an</translation>
    </message>
    <message>
        <source>No readings for</source>
        <translation>Keine Messwerte seit</translation>
    </message>
    <message>
        <source>Without a fresh reading for so long, everything stops</source>
        <translation>Ohne frischen Messwert so lange hält alles an</translation>
    </message>
    <message>
        <source>Stop at over-current bit</source>
        <translation>Beim Überstrombit anhalten</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Versorgung</translation>
    </message>
    <message>
        <source> V</source>
        <translation> V</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>As you measured it; without it nothing can be given in ohms</source>
        <translation>Wie Sie sie gemessen haben; ohne sie lässt sich nichts in Ohm angeben</translation>
    </message>
</context>
<context>
    <name>trex::BenchPanel</name>
    <message>
        <source>Parts of the bench test</source>
        <translation>Teile der Prüfung</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Steps and limits</source>
        <translation>Schritte und Grenzen</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Bench tests</source>
        <translation>Prüfstand</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Speeds and currents of the test</source>
        <translation>Geschwindigkeiten und Ströme der Prüfung</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Step or limits</source>
        <translation>Schritt oder Grenzen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Whole test</source>
        <translation>Ganze Prüfung</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Proposed settings</source>
        <translation>Vorgeschlagene Einstellungen</translation>
    </message>
    <message>
        <source>To a configuration file…</source>
        <translation>In eine Konfigurationsdatei …</translation>
    </message>
    <message>
        <source>What will happen</source>
        <translation>Was geschehen wird</translation>
    </message>
    <message>
        <source>Arm and start</source>
        <translation>Scharf schalten und starten</translation>
    </message>
    <message>
        <source>Do not start</source>
        <translation>Nicht starten</translation>
    </message>
    <message>
        <source>State of the test</source>
        <translation>Zustand der Prüfung</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Probelauf</translation>
    </message>
    <message>
        <source>Runs the test on a private simulated controller: no motor moves</source>
        <translation>Führt die Prüfung auf einem eigenen simulierten Regler aus: kein Motor bewegt sich</translation>
    </message>
    <message>
        <source>Start…</source>
        <translation>Starten …</translation>
    </message>
    <message>
        <source>HTML…</source>
        <translation>HTML …</translation>
    </message>
    <message>
        <source>Report as HTML</source>
        <translation>Bericht als HTML</translation>
    </message>
    <message>
        <source>PDF…</source>
        <translation>PDF …</translation>
    </message>
    <message>
        <source>Report as PDF</source>
        <translation>Bericht als PDF</translation>
    </message>
    <message>
        <source>Stop all motors</source>
        <translation>Alle Motoren anhalten</translation>
    </message>
    <message>
        <source>Comes with the program</source>
        <translation>Gehört zum Programm</translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation>Nicht verbunden.</translation>
    </message>
    <message>
        <source>Just stopped: no orders for half a second.</source>
        <translation>Eben angehalten: eine halbe Sekunde lang keine Befehle.</translation>
    </message>
    <message>
        <source>Serial does not control the motors (mode jumper, channel 5).</source>
        <translation>Die serielle Leitung steuert die Motoren nicht (Betriebsart-Jumper, Kanal 5).</translation>
    </message>
    <message>
        <source>In joint mode the controller measures no currents.</source>
        <translation>Im gemeinsamen Betrieb misst der Regler keine Ströme.</translation>
    </message>
    <message>
        <source>This test cannot be run: %1.</source>
        <translation>Diese Prüfung ist nicht ausführbar: %1.</translation>
    </message>
    <message>
        <source>Motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>Motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>The auxiliary motor</source>
        <translation>Der Hilfsmotor</translation>
    </message>
    <message>
        <source>%1 up to speed %2 (%3 %)</source>
        <translation>%1 bis Geschwindigkeit %2 (%3 %)</translation>
    </message>
    <message>
        <source>No motor is driven</source>
        <translation>Kein Motor wird angetrieben</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Runs the test on the motors, after a question</source>
        <translation>Führt die Prüfung mit den Motoren aus, nach einer Frage</translation>
    </message>
    <message>
        <source>%1; %2 s.</source>
        <translation>%1; %2 s.</translation>
    </message>
    <message>
        <source> (edited)</source>
        <translation> (geändert)</translation>
    </message>
    <message>
        <source>No results yet: try a dry run, or start the test.</source>
        <translation>Noch keine Ergebnisse: versuchen Sie einen Probelauf oder starten Sie die Prüfung.</translation>
    </message>
    <message>
        <source>(Dry run: a prediction.)</source>
        <translation>(Probelauf: eine Vorhersage.)</translation>
    </message>
    <message>
        <source>Proposed: %1: %2. %3</source>
        <translation>Vorschlag: %1: %2. %3</translation>
    </message>
    <message>
        <source>Dry run cancelled.</source>
        <translation>Probelauf abgebrochen.</translation>
    </message>
    <message>
        <source>Dry run: %1 s simulated.</source>
        <translation>Probelauf: %1 s simuliert.</translation>
    </message>
    <message>
        <source>Dry run of &quot;%1&quot;: %2</source>
        <translation>Probelauf von „%1“: %2</translation>
    </message>
    <message>
        <source>%1, for %2 s. Is the machine held fast or its wheels off the ground, and is everybody clear of it? STOP and Esc end it at once.</source>
        <translation>%1, für %2 s. Ist die Maschine festgehalten oder aufgebockt, und sind alle aus ihrem Bereich? STOP und Esc beenden es sofort.</translation>
    </message>
    <message>
        <source>Waiting for your word.</source>
        <translation>Wartet auf Ihr Wort.</translation>
    </message>
    <message>
        <source>Bench test &quot;%1&quot; started: %2.</source>
        <translation>Prüfung „%1“ begonnen: %2.</translation>
    </message>
    <message>
        <source>Running: %1 s, step %2.</source>
        <translation>Läuft: %1 s, Schritt %2.</translation>
    </message>
    <message>
        <source>Waiting for fresh readings.</source>
        <translation>Wartet auf frische Messwerte.</translation>
    </message>
    <message>
        <source>Bench test &quot;%1&quot;: %2</source>
        <translation>Prüfung „%1“: %2</translation>
    </message>
    <message>
        <source>Open a bench test</source>
        <translation>Prüfung öffnen</translation>
    </message>
    <message>
        <source>Bench tests (*.json)</source>
        <translation>Prüfungen (*.json)</translation>
    </message>
    <message>
        <source>Save the bench test</source>
        <translation>Prüfung speichern</translation>
    </message>
    <message>
        <source>Bench test saved to %1.</source>
        <translation>Prüfung in %1 gespeichert.</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
    <message>
        <source>Report written to %1.</source>
        <translation>Bericht in %1 geschrieben.</translation>
    </message>
    <message>
        <source>Proposed settings as a configuration file</source>
        <translation>Vorgeschlagene Einstellungen als Konfigurationsdatei</translation>
    </message>
    <message>
        <source>Configurations (*.json)</source>
        <translation>Konfigurationen (*.json)</translation>
    </message>
    <message>
        <source>Proposals written to %1. Load shows them in the parameters, where each is taken or left.</source>
        <translation>Vorschläge in %1 geschrieben. „Laden“ zeigt sie bei den Parametern, wo jeder übernommen oder gelassen wird.</translation>
    </message>
    <message>
        <source>The motor mode has not been read yet.</source>
        <translation>Der Motorbetrieb wurde noch nicht gelesen.</translation>
    </message>
</context>
<context>
    <name>trex::BenchResultModel</name>
    <message>
        <source>What you expect, in the result&apos;s unit; empty: nothing. It is kept with the test.</source>
        <translation>Was Sie erwarten, in der Einheit des Ergebnisses; leer: nichts. Es bleibt bei der Prüfung.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
</context>
<context>
    <name>trex::BenchStepForm</name>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>where it is</source>
        <translation>wo er ist</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Braking duty</source>
        <translation>Bremstastgrad</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Bit</source>
        <translation>Bit</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>or the test has failed</source>
        <translation>sonst ist die Prüfung nicht bestanden</translation>
    </message>
    <message>
        <source>Stop above</source>
        <translation>Halt über</translation>
    </message>
    <message>
        <source> A</source>
        <translation> A</translation>
    </message>
    <message>
        <source>as the test</source>
        <translation>wie die Prüfung</translation>
    </message>
    <message>
        <source>A current limit of this step&apos;s own</source>
        <translation>Eine eigene Stromgrenze dieses Schrittes</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Bezeichnung</translation>
    </message>
    <message>
        <source>shown in the plot</source>
        <translation>steht im Diagramm</translation>
    </message>
    <message>
        <source>What the step does</source>
        <translation>Was der Schritt tut</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>What it waits for</source>
        <translation>Worauf er wartet</translation>
    </message>
    <message>
        <source>Status bit</source>
        <translation>Statusbit</translation>
    </message>
    <message>
        <source>Do</source>
        <translation>Tut</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
</context>
<context>
    <name>trex::BenchStepModel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>trex::CalibrationHistory</name>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Raw: minimum %1, neutral %2, maximum %3, deadband %4</source>
        <translation>Rohwerte: Minimum %1, Neutral %2, Maximum %3, Totband %4</translation>
    </message>
    <message>
        <source>Calibration history</source>
        <translation>Verlauf der Kalibrierungen</translation>
    </message>
    <message>
        <source>Calibrations written before, newest first</source>
        <translation>Früher geschriebene Kalibrierungen, neueste zuerst</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>What can be restored</source>
        <translation>Was sich wiederherstellen lässt</translation>
    </message>
    <message>
        <source>Restore the numbers before</source>
        <translation>Vorherige Zahlen wiederherstellen</translation>
    </message>
    <message>
        <source>Restore the written numbers</source>
        <translation>Geschriebene Zahlen wiederherstellen</translation>
    </message>
    <message>
        <source>RC</source>
        <translation>RC</translation>
    </message>
    <message>
        <source>analog</source>
        <translation>Analog</translation>
    </message>
    <message>
        <source>No %1 calibration was written to this controller by this program yet.</source>
        <translation>Dieses Programm hat noch keine %1-Kalibrierung in diesen Controller geschrieben.</translation>
    </message>
    <message>
        <source>%1 calibrations written to %2, device %3</source>
        <translation>%1-Kalibrierungen, geschrieben in %2, Gerät %3</translation>
    </message>
    <message>
        <source>By %1, on %2</source>
        <translation>Von %1, an %2</translation>
    </message>
    <message>
        <source>Connect to the controller to restore.</source>
        <translation>Zum Wiederherstellen mit dem Controller verbinden.</translation>
    </message>
    <message>
        <source>Settings can be written in serial mode only.</source>
        <translation>Einstellungen lassen sich nur im seriellen Modus schreiben.</translation>
    </message>
    <message>
        <source>A calibration is running.</source>
        <translation>Eine Kalibrierung läuft.</translation>
    </message>
    <message>
        <source>Writing, and reading back…</source>
        <translation>Schreiben und Zurücklesen…</translation>
    </message>
    <message>
        <source>Channel %1 holds %2 again, read back.</source>
        <translation>Kanal %1 enthält wieder %2, zurückgelesen.</translation>
    </message>
    <message>
        <source>Channel %1 holds %2, the nearest that this controller can take, read back.</source>
        <translation>Kanal %1 enthält %2, das Nächstliegende, das dieser Controller annehmen kann, zurückgelesen.</translation>
    </message>
    <message>
        <source>Restoring writes the numbers of the chosen line to its channel, and reads them back.</source>
        <translation>Das Wiederherstellen schreibt die Zahlen der gewählten Zeile in ihren Kanal und liest sie zurück.</translation>
    </message>
</context>
<context>
    <name>trex::CalibrationPanel</name>
    <message>
        <source>Calibration wizard</source>
        <translation>Kalibrierassistent</translation>
    </message>
    <message>
        <source>Calibration: %1</source>
        <translation>Kalibrierung: %1</translation>
    </message>
    <message>
        <source>The calibration&apos;s panel was closed.</source>
        <translation>Der Bereich Kalibrierung wurde geschlossen.</translation>
    </message>
</context>
<context>
    <name>trex::CalibrationRow</name>
    <message>
        <source>Channel %1</source>
        <translation>Kanal %1</translation>
    </message>
    <message>
        <source>Use channel %1</source>
        <translation>Kanal %1 verwenden</translation>
    </message>
    <message>
        <source>State of channel %1</source>
        <translation>Zustand von Kanal %1</translation>
    </message>
    <message>
        <source>Details of channel %1</source>
        <translation>Einzelheiten zu Kanal %1</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Neutral</source>
        <translation>Neutral</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Deadband</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>%1 of channel %2</source>
        <translation>%1 von Kanal %2</translation>
    </message>
    <message>
        <source>%1 of channel %2 before</source>
        <translation>%1 von Kanal %2 zuvor</translation>
    </message>
    <message>
        <source>Raw value %1</source>
        <translation>Rohwert %1</translation>
    </message>
    <message>
        <source>was %1</source>
        <translation>war %1</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Reverse channel %1</source>
        <translation>Kanal %1 umkehren</translation>
    </message>
    <message>
        <source>Find the direction of channel %1 again</source>
        <translation>Richtung von Kanal %1 nochmals ermitteln</translation>
    </message>
    <message>
        <source>Parameter 0x03: forward and reverse change places on this channel. Only its own bit is written.</source>
        <translation>Parameter 0x03: Vorwärts und rückwärts werden auf diesem Kanal vertauscht. Nur sein eigenes Bit wird geschrieben.</translation>
    </message>
    <message>
        <source>Push this channel forward once more.</source>
        <translation>Diesen Kanal noch einmal nach vorn drücken.</translation>
    </message>
</context>
<context>
    <name>trex::CalibrationWizard</name>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>What to do now</source>
        <translation>Was jetzt zu tun ist</translation>
    </message>
    <message>
        <source>Notice</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Countdown</source>
        <translation>Countdown</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Neutral</source>
        <translation>Neutral</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Deadband</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>Why it cannot go on yet</source>
        <translation>Warum es noch nicht weitergeht</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel the calibration</source>
        <translation>Kalibrierung abbrechen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Back one step</source>
        <translation>Einen Schritt zurück</translation>
    </message>
    <message>
        <source>Motor power is off</source>
        <translation>Motorversorgung ist aus</translation>
    </message>
    <message>
        <source>The controller drives the motors by the sticks in this mode. Tick this when their power is off, so that nothing can move.</source>
        <translation>In diesem Modus steuert der Controller die Motoren nach den Knüppeln. Ankreuzen, wenn ihre Versorgung aus ist, sodass sich nichts bewegen kann.</translation>
    </message>
    <message>
        <source>History…</source>
        <translation>Verlauf…</translation>
    </message>
    <message>
        <source>Calibrations of before</source>
        <translation>Frühere Kalibrierungen</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kennlinie</translation>
    </message>
    <message>
        <source>Show the response curve</source>
        <translation>Kennlinie zeigen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Put the former values back</source>
        <translation>Frühere Werte wiederherstellen</translation>
    </message>
    <message>
        <source>Writes the values of before this calibration, and reads them back.</source>
        <translation>Schreibt die Werte von vor dieser Kalibrierung und liest sie zurück.</translation>
    </message>
</context>
<context>
    <name>trex::CalibrationWriter</name>
    <message>
        <source>The controller already held these values; nothing was written.</source>
        <translation>Der Controller hatte diese Werte bereits; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Nothing was changed in the controller.</source>
        <translation>Im Controller wurde nichts geändert.</translation>
    </message>
    <message>
        <source>Channels written and read back: %1.</source>
        <translation>Geschriebene und zurückgelesene Kanäle: %1.</translation>
    </message>
    <message>
        <source>Channels written as the nearest values that this controller can take: %1 (it reads the bytes of a calibration as 8 bits each).</source>
        <translation>Mit den nächstliegenden Werten, die dieser Controller annehmen kann, geschriebene Kanäle: %1 (er liest die Bytes einer Kalibrierung als je 8 Bit).</translation>
    </message>
    <message>
        <source>Channels that were so already: %1.</source>
        <translation>Kanäle, die bereits so waren: %1.</translation>
    </message>
    <message>
        <source>Channel %1 was refused and keeps its old values.</source>
        <translation>Kanal %1 wurde abgelehnt und behält seine alten Werte.</translation>
    </message>
    <message>
        <source>Channel %1 may hold its old or its new values: read it again.</source>
        <translation>Kanal %1 kann seine alten oder seine neuen Werte enthalten: erneut lesen.</translation>
    </message>
    <message>
        <source>The directions (parameter 0x03) may be the old or the new ones.</source>
        <translation>Die Richtungen (Parameter 0x03) können die alten oder die neuen sein.</translation>
    </message>
    <message>
        <source>The directions (parameter 0x03) were refused and stay as they were.</source>
        <translation>Die Richtungen (Parameter 0x03) wurden abgelehnt und bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>All other channels are as before.</source>
        <translation>Alle anderen Kanäle sind wie zuvor.</translation>
    </message>
    <message>
        <source>Channel %1 holds the new values</source>
        <translation>Kanal %1 enthält die neuen Werte</translation>
    </message>
    <message>
        <source>Channels %1 hold the new values</source>
        <translation>Kanäle %1 enthalten die neuen Werte</translation>
    </message>
    <message>
        <source>Channel %1 still holds the old values</source>
        <translation>Kanal %1 enthält noch die alten Werte</translation>
    </message>
    <message>
        <source>channel %1 still the old ones</source>
        <translation>Kanal %1 noch die alten</translation>
    </message>
    <message>
        <source>Channels %1 still hold the old values</source>
        <translation>Kanäle %1 enthalten noch die alten Werte</translation>
    </message>
    <message>
        <source>channels %1 still the old ones</source>
        <translation>Kanäle %1 noch die alten</translation>
    </message>
    <message>
        <source>channel %1 holds neither the old nor the new values: undo, or calibrate it again</source>
        <translation>Kanal %1 enthält weder die alten noch die neuen Werte: rückgängig machen oder neu kalibrieren</translation>
    </message>
    <message>
        <source>Read back: %1.</source>
        <translation>Zurückgelesen: %1.</translation>
    </message>
    <message>
        <source>The directions (parameter 0x03) are the new ones.</source>
        <translation>Die Richtungen (Parameter 0x03) sind die neuen.</translation>
    </message>
    <message>
        <source>The directions (parameter 0x03) are still the old ones.</source>
        <translation>Die Richtungen (Parameter 0x03) sind noch die alten.</translation>
    </message>
    <message>
        <source>The directions (parameter 0x03) are neither the old nor the new ones.</source>
        <translation>Die Richtungen (Parameter 0x03) sind weder die alten noch die neuen.</translation>
    </message>
    <message>
        <source>The former values are back, and were read back: channels %1.</source>
        <translation>Die früheren Werte sind wiederhergestellt und zurückgelesen: Kanäle %1.</translation>
    </message>
    <message>
        <source>The nearest to the former values that this controller can take: channels %1.</source>
        <translation>So nah an den früheren Werten, wie es dieser Controller zulässt: Kanäle %1.</translation>
    </message>
    <message>
        <source>The directions (parameter 0x03) are as they were.</source>
        <translation>Die Richtungen (Parameter 0x03) sind wie zuvor.</translation>
    </message>
    <message>
        <source>Directions (parameter 0x03) written and read back: %1.</source>
        <translation>Richtungen (Parameter 0x03) geschrieben und zurückgelesen: %1.</translation>
    </message>
</context>
<context>
    <name>trex::ChannelBar</name>
    <message>
        <source>Channel %1</source>
        <translation>Kanal %1</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>– no pulse</source>
        <translation>– kein Impuls</translation>
    </message>
    <message>
        <source>%1, old</source>
        <translation>%1, veraltet</translation>
    </message>
    <message>
        <source>Calibration: minimum %1, neutral %2, maximum %3, deadband ±%4</source>
        <translation>Kalibrierung: Minimum %1, Neutral %2, Maximum %3, Totband ±%4</translation>
    </message>
    <message>
        <source>no pulse</source>
        <translation>kein Impuls</translation>
    </message>
</context>
<context>
    <name>trex::ChannelCalibration</name>
    <message>
        <source>The controller was switched off and on.</source>
        <translation>Der Controller wurde aus- und eingeschaltet.</translation>
    </message>
    <message>
        <source>The motors were armed, which ends a calibration.</source>
        <translation>Die Motoren wurden scharf geschaltet; das beendet eine Kalibrierung.</translation>
    </message>
    <message>
        <source>Cancelled on request.</source>
        <translation>Auf Wunsch abgebrochen.</translation>
    </message>
    <message>
        <source>Writing channel %1</source>
        <translation>Kanal %1 wird geschrieben</translation>
    </message>
    <message>
        <source>Cancelled: nothing was changed.</source>
        <translation>Abgebrochen: Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The connection to the controller was lost.</source>
        <translation>Die Verbindung zum Controller ging verloren.</translation>
    </message>
    <message>
        <source>The controller changed between RC and analog inputs, whose calibrations differ.</source>
        <translation>Der Controller hat zwischen RC- und Analogeingängen gewechselt, deren Kalibrierungen verschieden sind.</translation>
    </message>
    <message>
        <source>Connect to a controller first.</source>
        <translation>Zuerst mit einem Controller verbinden.</translation>
    </message>
    <message>
        <source>Reading the present calibrations…</source>
        <translation>Aktuelle Kalibrierungen werden gelesen…</translation>
    </message>
    <message>
        <source>Choose at least one channel.</source>
        <translation>Mindestens einen Kanal wählen.</translation>
    </message>
    <message>
        <source>Stopping behind this channel…</source>
        <translation>Halt nach diesem Kanal…</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Schreiben…</translation>
    </message>
    <message>
        <source>No fresh readings come from the controller.</source>
        <translation>Vom Controller kommen keine neuen Messwerte.</translation>
    </message>
    <message>
        <source>Channel %1 gives no valid reading. Connect it, or go back and leave it out.</source>
        <translation>Kanal %1 liefert keinen gültigen Messwert. Anschließen, oder zurückgehen und auslassen.</translation>
    </message>
    <message>
        <source>Hold still for %1 s more.</source>
        <translation>Noch %1 s stillhalten.</translation>
    </message>
    <message>
        <source>Something still drifts: hold still.</source>
        <translation>Noch driftet etwas: stillhalten.</translation>
    </message>
    <message>
        <source>Channels still to be moved to both ends: %1.</source>
        <translation>Kanäle, die noch in beide Endlagen zu bewegen sind: %1.</translation>
    </message>
    <message>
        <source>Waiting until no end moves further…</source>
        <translation>Warten, bis sich keine Endlage mehr verschiebt…</translation>
    </message>
    <message>
        <source>Settings can be written in serial mode only: the controller would refuse. Switch its power off, take the mode jumper off, switch it on and calibrate again.</source>
        <translation>Einstellungen lassen sich nur im seriellen Modus schreiben: Der Controller würde ablehnen. Ausschalten, Modus-Steckbrücke abziehen, einschalten und neu kalibrieren.</translation>
    </message>
    <message>
        <source>No channel was learned well enough to be written.</source>
        <translation>Kein Kanal wurde gut genug gelernt, um geschrieben zu werden.</translation>
    </message>
    <message>
        <source>Choose at least one channel to write.</source>
        <translation>Mindestens einen Kanal zum Schreiben wählen.</translation>
    </message>
    <message>
        <source>Writing the directions</source>
        <translation>Richtungen werden geschrieben</translation>
    </message>
    <message>
        <source>The connection to the controller was lost while the former values were put back.</source>
        <translation>Die Verbindung zum Controller ging verloren, während die früheren Werte wiederhergestellt wurden.</translation>
    </message>
    <message>
        <source>In RC and analog mode the sticks move the motors: switch the motors&apos; power off and tick that it is off, or put the controller into serial mode.</source>
        <translation>Im RC- und Analogmodus bewegen die Knüppel die Motoren: die Motorversorgung ausschalten und ankreuzen, dass sie aus ist, oder den Controller in den seriellen Modus versetzen.</translation>
    </message>
    <message>
        <source>Say first that the motor power is off.</source>
        <translation>Zuerst angeben, dass die Motorversorgung aus ist.</translation>
    </message>
    <message>
        <source>Putting the former values back…</source>
        <translation>Frühere Werte werden wiederhergestellt…</translation>
    </message>
    <message>
        <source>Reading back what the controller holds…</source>
        <translation>Zurücklesen, was der Controller enthält…</translation>
    </message>
    <message>
        <source>When the controller is there again, what it holds is read back.</source>
        <translation>Sobald der Controller wieder da ist, wird zurückgelesen, was er enthält.</translation>
    </message>
    <message>
        <source>Channels to be held at each end for longer: %1.</source>
        <translation>Kanäle, die an jedem Ende länger zu halten sind: %1.</translation>
    </message>
</context>
<context>
    <name>trex::ChannelsPanel</name>
    <message>
        <source>Calibrate…</source>
        <translation>Kalibrieren…</translation>
    </message>
    <message>
        <source>Calibrate the channels</source>
        <translation>Die Kanäle kalibrieren</translation>
    </message>
    <message>
        <source>Channel %1 learned</source>
        <translation>Kanal %1 gelernt</translation>
    </message>
    <message>
        <source>Channel %1 input</source>
        <translation>Kanal %1 Eingang</translation>
    </message>
    <message>
        <source>Channel %1 remapped</source>
        <translation>Kanal %1 umgerechnet</translation>
    </message>
    <message>
        <source>Remapped value, −127 to 127: what the motor would be told</source>
        <translation>Umgerechneter Wert, −127 bis 127: was der Motor als Vorgabe erhielte</translation>
    </message>
    <message>
        <source>RC pulses</source>
        <translation>RC-Impulse</translation>
    </message>
    <message>
        <source>Analog voltages</source>
        <translation>Analogspannungen</translation>
    </message>
    <message>
        <source>Learned: calibrated for this transmitter</source>
        <translation>Gelernt: für diesen Sender kalibriert</translation>
    </message>
    <message>
        <source>Not learned: the factory&apos;s calibration</source>
        <translation>Nicht gelernt: Kalibrierung ab Werk</translation>
    </message>
    <message>
        <source>Motor 1, or turn</source>
        <translation>Motor 1 oder Lenken</translation>
    </message>
    <message>
        <source>Motor 2, or forward</source>
        <translation>Motor 2 oder Fahren</translation>
    </message>
    <message>
        <source>Auxiliary motor</source>
        <translation>Hilfsmotor</translation>
    </message>
    <message>
        <source>Flip switch</source>
        <translation>Überkopfschalter</translation>
    </message>
    <message>
        <source>Serial override</source>
        <translation>Serielle Übernahme</translation>
    </message>
    <message>
        <source>Drives motor 1; with the mix jumper on, steers both motors.</source>
        <translation>Steuert Motor 1; mit Mix-Steckbrücke lenkt er beide Motoren.</translation>
    </message>
    <message>
        <source>Drives motor 2; with the mix jumper on, drives both motors.</source>
        <translation>Steuert Motor 2; mit Mix-Steckbrücke treibt er beide Motoren an.</translation>
    </message>
    <message>
        <source>Speed of the auxiliary motor, in one direction.</source>
        <translation>Drehzahl des Hilfsmotors, in einer Richtung.</translation>
    </message>
    <message>
        <source>Low: the robot is upside down; motors and directions swap.</source>
        <translation>Niedrig: der Roboter liegt auf dem Kopf; Motoren und Richtungen werden getauscht.</translation>
    </message>
    <message>
        <source>Low: serial commands drive the motors instead of the channels.</source>
        <translation>Niedrig: serielle Befehle steuern die Motoren anstelle der Kanäle.</translation>
    </message>
</context>
<context>
    <name>trex::CheckpointModel</name>
    <message>
        <source>(saved before a first write)</source>
        <translation>(gespeichert vor einem ersten Schreiben)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controller</translation>
    </message>
</context>
<context>
    <name>trex::CommandBar</name>
    <message>
        <source>RC mode</source>
        <translation>RC-Modus</translation>
    </message>
    <message>
        <source>analog mode</source>
        <translation>Analogmodus</translation>
    </message>
    <message>
        <source>serial mode (RC inputs)</source>
        <translation>serieller Modus (RC-Eingänge)</translation>
    </message>
    <message>
        <source>serial mode (analog inputs)</source>
        <translation>serieller Modus (Analogeingänge)</translation>
    </message>
    <message>
        <source>simulated controller</source>
        <translation>simulierter Controller</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Connects to the port used last.</source>
        <translation>Verbindet mit dem zuletzt verwendeten Port.</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Stops all motors and closes the line.</source>
        <translation>Hält alle Motoren an und schließt die Verbindung.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Stop all motors</source>
        <translation>Alle Motoren anhalten</translation>
    </message>
    <message>
        <source>Stop all motors	Esc</source>
        <translation>Alle Motoren anhalten	Esc</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>What is connected</source>
        <translation>Was verbunden ist</translation>
    </message>
    <message>
        <source>Stops all motors and takes no more orders for them.</source>
        <translation>Hält alle Motoren an und nimmt keine Befehle mehr für sie an.</translation>
    </message>
    <message>
        <source>Lets the sliders drive the motors.</source>
        <translation>Lässt die Schieberegler die Motoren antreiben.</translation>
    </message>
    <message>
        <source>No controller connected</source>
        <translation>Kein Controller verbunden</translation>
    </message>
</context>
<context>
    <name>trex::CompareDialog</name>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Compare settings</source>
        <translation>Einstellungen vergleichen</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Linke Seite</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>Rechte Seite</translation>
    </message>
    <message>
        <source>&amp;Copy as text</source>
        <translation>Als Text &amp;kopieren</translation>
    </message>
    <message>
        <source>In the controller</source>
        <translation>Im Controller</translation>
    </message>
    <message>
        <source>Factory defaults</source>
        <translation>Werkseinstellungen</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei…</translation>
    </message>
    <message>
        <source>%1: a file</source>
        <translation>%1: eine Datei</translation>
    </message>
    <message>
        <source>Settings to compare</source>
        <translation>Zu vergleichende Einstellungen</translation>
    </message>
    <message>
        <source>Configuration (*.json)</source>
        <translation>Konfiguration (*.json)</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>The controller&apos;s settings are not read: connect first.</source>
        <translation>Die Einstellungen des Controllers sind nicht gelesen: zuerst verbinden.</translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation>Keine Unterschiede.</translation>
    </message>
    <message>
        <source>%1 settings differ.</source>
        <translation>Verschiedene Einstellungen: %1.</translation>
    </message>
    <message>
        <source>1 setting differs.</source>
        <translation>1 Einstellung unterscheidet sich.</translation>
    </message>
    <message>
        <source>Calibrations are left out: their defaults are not known. Defaults marked ≈ are guesses: the vendor does not state them.</source>
        <translation>Kalibrierungen fehlen hier: Ihre Standardwerte sind nicht bekannt. Mit ≈ markierte Standardwerte sind Vermutungen: Der Hersteller nennt sie nicht.</translation>
    </message>
</context>
<context>
    <name>trex::CompareList</name>
    <message>
        <source>fixed in the view</source>
        <translation>fest in der Ansicht</translation>
    </message>
    <message>
        <source>by time, start on start</source>
        <translation>nach der Zeit, Anfang auf Anfang</translation>
    </message>
    <message>
        <source>by the trigger</source>
        <translation>nach dem Trigger</translation>
    </message>
    <message>
        <source>by the command step</source>
        <translation>nach dem Sprung des Befehls</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Nothing to compare with. Freeze what the plots show now, or open a recording.</source>
        <translation>Nichts zum Vergleichen. Frieren Sie ein, was die Diagramme jetzt zeigen, oder öffnen Sie eine Aufzeichnung.</translation>
    </message>
    <message>
        <source>Freeze the view</source>
        <translation>Ansicht einfrieren</translation>
    </message>
    <message>
        <source>Keep what the plots show now as a reference behind the curves</source>
        <translation>Was die Diagramme jetzt zeigen, als Vergleich hinter den Kurven behalten</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Name of the run</source>
        <translation>Name des Laufs</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>No longer compare with it</source>
        <translation>Nicht mehr damit vergleichen</translation>
    </message>
    <message>
        <source>Shift of %1</source>
        <translation>Verschiebung von %1</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>cannot be aligned: no such moment</source>
        <translation>nicht ausrichtbar: kein solcher Zeitpunkt</translation>
    </message>
</context>
<context>
    <name>trex::ConfigTransfer</name>
    <message>
        <source>%1: this controller takes calibration bytes in another way; the nearest value that it can take is written.</source>
        <translation>%1: Dieser Controller nimmt Kalibrierungsbytes auf andere Weise an; geschrieben ist der nächstliegende Wert, den er annehmen kann.</translation>
    </message>
    <message>
        <source>%1 while the controller uses its other inputs</source>
        <translation>%1, während der Controller seine anderen Eingänge verwendet</translation>
    </message>
    <message>
        <source>The last check of all settings could not be done: %1</source>
        <translation>Die letzte Prüfung aller Einstellungen war nicht möglich: %1</translation>
    </message>
    <message>
        <source>%1 reads %2 now, though nothing was written to it; it is left as it is.</source>
        <translation>%1 ist jetzt als %2 zu lesen, obwohl nichts dorthin geschrieben wurde; es bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>%1 had been changed by a damaged packet; it is put right.</source>
        <translation>%1 war durch ein beschädigtes Paket verändert; es ist berichtigt.</translation>
    </message>
    <message>
        <source>%1 did not hold what it should; it is put right.</source>
        <translation>%1 enthielt nicht den richtigen Wert; es ist berichtigt.</translation>
    </message>
</context>
<context>
    <name>trex::ConnectionPanel</name>
    <message>
        <source>State of the link</source>
        <translation>Zustand der Verbindung</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>A serial port, tcp://HOST:PORT of a serial server, or the simulator.</source>
        <translation>Ein serieller Port, tcp://HOST:PORT eines seriellen Servers oder der Simulator.</translation>
    </message>
    <message>
        <source>Po&amp;rt</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Trennen</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>S&amp;uchen</translation>
    </message>
    <message>
        <source>Power c&amp;ycle</source>
        <translation>Aus und &amp;ein</translation>
    </message>
    <message>
        <source>Stops all three motors, then closes the port.</source>
        <translation>Hält alle drei Motoren an und schließt dann den Port.</translation>
    </message>
    <message>
        <source>Tries every baud rate and error detection on this port, the most likely first, until a controller answers.</source>
        <translation>Probiert an diesem Port alle Baudraten und Fehlererkennungen, die wahrscheinlichsten zuerst, bis ein Controller antwortet.</translation>
    </message>
    <message>
        <source>Switches the simulated controller off and on again.</source>
        <translation>Schaltet den simulierten Controller aus und wieder ein.</translation>
    </message>
    <message>
        <source>%1 (%2 of %3, at most about %4 s more).</source>
        <translation>%1 (%2 von %3, höchstens noch etwa %4 s).</translation>
    </message>
    <message>
        <source>%1 (%2 of %3).</source>
        <translation>%1 (%2 von %3).</translation>
    </message>
    <message>
        <source>Scan cancelled. Nothing was found so far.</source>
        <translation>Suche abgebrochen. Bisher wurde nichts gefunden.</translation>
    </message>
    <message>
        <source>Cancel &amp;scan</source>
        <translation>S&amp;uche abbrechen</translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation>getrennt</translation>
    </message>
    <message>
        <source>connecting to %1, %2</source>
        <translation>verbindet mit %1, %2</translation>
    </message>
    <message>
        <source>connected to a %1, firmware %2, on %3</source>
        <translation>verbunden mit %1, Firmware %2, an %3</translation>
    </message>
    <message>
        <source>connected to %1</source>
        <translation>verbunden mit %1</translation>
    </message>
    <message>
        <source>lost: values are no longer live</source>
        <translation>verloren: Werte sind nicht mehr aktuell</translation>
    </message>
    <message>
        <source>retrying %1</source>
        <translation>neuer Versuch mit %1</translation>
    </message>
    <message>
        <source>No port found. Plug in the adapter, or simulate.</source>
        <translation>Kein Port gefunden. Adapter einstecken oder simulieren.</translation>
    </message>
    <message>
        <source>On a network port, speed and parity are those of the serial server.</source>
        <translation>Bei einem Netzwerkport gelten Geschwindigkeit und Parität des seriellen Servers.</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederfinden</translation>
    </message>
    <message>
        <source>Finds a lost controller: tries the settings that worked last, then every other, and connects with those that answer. The questions are chosen so that no controller at another speed takes one for a motor order, as far as its receiver works as its data sheet says; to be quite sure, switch the motor power off first.</source>
        <translation>Findet einen verlorenen Regler: versucht zuerst die Einstellungen, die zuletzt gingen, dann alle anderen, und verbindet mit denen, die antworten. Die Fragen sind so gewählt, dass kein Regler mit anderer Geschwindigkeit eine davon für einen Motorbefehl hält, soweit sein Empfänger arbeitet, wie es sein Datenblatt sagt; um ganz sicher zu gehen, vorher die Motorversorgung abschalten.</translation>
    </message>
    <message>
        <source>Found a %1, firmware %2, at %3, device number %4.</source>
        <translation>Gefunden: %1, Firmware %2, mit %3, Gerätenummer %4.</translation>
    </message>
    <message>
        <source>%1 Press Connect.</source>
        <translation>%1 „Verbinden“ drücken.</translation>
    </message>
    <message>
        <source>No controller answered on %1 at any speed. %2</source>
        <translation>Auf %1 hat bei keiner Geschwindigkeit ein Regler geantwortet. %2</translation>
    </message>
    <message>
        <source>Cancel sea&amp;rch</source>
        <translation>Suche abbre&amp;chen</translation>
    </message>
    <message>
        <source>It is tried again by itself until you disconnect. Recover looks for it at every speed.</source>
        <translation>Es wird von selbst weiter versucht, bis Sie trennen. „Wiederfinden“ sucht mit jeder Geschwindigkeit.</translation>
    </message>
    <message>
        <source>A controller fresh from the factory talks at 19200 baud without error detection. Recover looks for it at every speed.</source>
        <translation>Ein Regler ab Werk spricht mit 19200 Baud ohne Fehlererkennung. „Wiederfinden“ sucht mit jeder Geschwindigkeit.</translation>
    </message>
</context>
<context>
    <name>trex::Controller</name>
    <message>
        <source>Armed: motor orders are sent.</source>
        <translation>Scharf: Motorbefehle werden gesendet.</translation>
    </message>
    <message>
        <source>A reply with latched bits was lost on the line; bits that it carried may be missing from the counts.</source>
        <translation>Eine Antwort mit gespeicherten Bits ging auf der Leitung verloren; ihre Bits fehlen möglicherweise in den Zählern.</translation>
    </message>
    <message>
        <source>The line echoes what is sent (RS-232 wiring); the echo is dropped.</source>
        <translation>Die Leitung gibt Gesendetes als Echo zurück (RS-232-Verkabelung); das Echo wird verworfen.</translation>
    </message>
    <message>
        <source>Stop sent to all three motors (%1 ms).</source>
        <translation>Stopp an alle drei Motoren gesendet (%1 ms).</translation>
    </message>
    <message>
        <source>Stop could not be sent: %1</source>
        <translation>Stopp konnte nicht gesendet werden: %1</translation>
    </message>
    <message>
        <source>Not connected: %1</source>
        <translation>Nicht verbunden: %1</translation>
    </message>
    <message>
        <source>Disconnected.</source>
        <translation>Getrennt.</translation>
    </message>
    <message>
        <source>Connecting to %1 at %2 baud.</source>
        <translation>Verbindung zu %1 wird mit %2 Baud aufgebaut.</translation>
    </message>
    <message>
        <source>Connected to a %1, firmware %2.</source>
        <translation>Verbunden mit %1, Firmware %2.</translation>
    </message>
    <message>
        <source>Connected.</source>
        <translation>Verbunden.</translation>
    </message>
    <message>
        <source>Link lost: %1</source>
        <translation>Verbindung verloren: %1</translation>
    </message>
    <message>
        <source>Link lost.</source>
        <translation>Verbindung verloren.</translation>
    </message>
    <message>
        <source>Trying again: %1</source>
        <translation>Neuer Versuch: %1</translation>
    </message>
    <message>
        <source>The controller was restarted: %1.</source>
        <translation>Der Controller wurde neu gestartet: %1.</translation>
    </message>
    <message>
        <source>its channel inputs are read as voltages now, which only a power cycle brings about</source>
        <translation>seine Kanaleingänge werden jetzt als Spannungen gelesen, was nur ein Aus- und Einschalten bewirkt</translation>
    </message>
    <message>
        <source>its channel inputs are read as RC pulses now, which only a power cycle brings about</source>
        <translation>seine Kanaleingänge werden jetzt als RC-Impulse gelesen, was nur ein Aus- und Einschalten bewirkt</translation>
    </message>
    <message>
        <source>The controller was silent and answers again: it may have been restarted. Everything is read anew.</source>
        <translation>Der Controller schwieg und antwortet wieder: Er wurde möglicherweise neu gestartet. Alles wird neu gelesen.</translation>
    </message>
    <message>
        <source>Disarmed: %1.</source>
        <translation>Gesichert: %1.</translation>
    </message>
    <message>
        <source>Disarmed: %1 (%2).</source>
        <translation>Gesichert: %1 (%2).</translation>
    </message>
    <message>
        <source>Stall guard: motor %1 drew %2 A for %3 ms. All motors are led to zero.</source>
        <translation>Blockierschutz: Motor %1 zog %3 ms lang %2 A. Alle Motoren werden auf null geführt.</translation>
    </message>
</context>
<context>
    <name>trex::CurrentReadOut</name>
    <message>
        <source>%1 current</source>
        <translation>Strom %1</translation>
    </message>
    <message>
        <source>peak %1</source>
        <translation>Spitze %1</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>Mittel %1</translation>
    </message>
</context>
<context>
    <name>trex::CurrentValue</name>
    <message>
        <source>The scale of a TReX, about 150 mA a count, is inferred.</source>
        <translation>Die Skala eines TReX, etwa 150 mA je Schritt, ist gefolgert.</translation>
    </message>
</context>
<context>
    <name>trex::CurrentsPanel</name>
    <message>
        <source>The samples of the session were cleared.</source>
        <translation>Die Messwerte der Sitzung wurden gelöscht.</translation>
    </message>
    <message>
        <source>Export the visible part</source>
        <translation>Sichtbaren Teil exportieren</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>All samples as CSV (*.csv);;Plot as picture (*.png)</source>
        <translation>Alle Messwerte als CSV (*.csv);;Diagramm als Bild (*.png)</translation>
    </message>
    <message>
        <source>Plot saved as %1.</source>
        <translation>Diagramm gespeichert als %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) exported to %1.</source>
        <translation>
            <numerusform>%n Messwert nach %1 exportiert.</numerusform>
            <numerusform>%n Messwerte nach %1 exportiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Record the currents to a file</source>
        <translation>Ströme in eine Datei aufzeichnen</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message numerus="yes">
        <source>Recording ended: %n sample(s) in %1.</source>
        <translation>
            <numerusform>Aufzeichnung beendet: %n Messwert in %1.</numerusform>
            <numerusform>Aufzeichnung beendet: %n Messwerte in %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording the currents to %1.</source>
        <translation>Ströme werden in %1 aufgezeichnet.</translation>
    </message>
    <message>
        <source>Recording ended: %1</source>
        <translation>Aufzeichnung beendet: %1</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>%1: click to end the recording</source>
        <translation>%1: Klick beendet die Aufzeichnung</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Write every sample from now on to a CSV file, at once</source>
        <translation>Ab jetzt jeden Messwert sofort in eine CSV-Datei schreiben</translation>
    </message>
    <message>
        <source>Motor currents over time</source>
        <translation>Motorströme im Zeitverlauf</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Gezeigte Zeit</translation>
    </message>
    <message>
        <source>How much time the plot shows</source>
        <translation>Wie viel Zeit das Diagramm zeigt</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Hold the picture still; recording goes on behind</source>
        <translation>Bild anhalten; die Aufzeichnung läuft im Hintergrund weiter</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Show everything recorded in this session</source>
        <translation>Alles in dieser Sitzung Aufgezeichnete zeigen</translation>
    </message>
    <message>
        <source>Save all samples as CSV, or the plot as a PNG picture</source>
        <translation>Alle Messwerte als CSV oder das Diagramm als PNG-Bild speichern</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Forget all samples of this session and start anew</source>
        <translation>Alle Messwerte dieser Sitzung löschen und neu beginnen</translation>
    </message>
    <message>
        <source>All samples or picture…</source>
        <translation>Alle Messwerte oder Bild…</translation>
    </message>
    <message>
        <source>Visible part…</source>
        <translation>Sichtbarer Teil…</translation>
    </message>
    <message>
        <source>Motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>Motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Motor currents are not available in joint mode.</source>
        <translation>Im gemeinsamen Modus sind keine Motorströme verfügbar.</translation>
    </message>
    <message>
        <source>No samples yet. Connect to a controller, or simulate one.</source>
        <translation>Noch keine Messwerte. Mit einem Controller verbinden oder einen simulieren.</translation>
    </message>
    <message>
        <source>not available in joint mode</source>
        <translation>im gemeinsamen Modus nicht verfügbar</translation>
    </message>
    <message>
        <source>%1 s old</source>
        <translation>%1 s alt</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Two cursors to measure with (1 and 2 in the plot)</source>
        <translation>Zwei Cursor zum Messen (1 und 2 im Diagramm)</translation>
    </message>
</context>
<context>
    <name>trex::CurveBox</name>
    <message>
        <source>Channel whose response is drawn</source>
        <translation>Kanal, dessen Kennlinie gezeichnet ist</translation>
    </message>
    <message>
        <source>Confidence in figures</source>
        <translation>Verlässlichkeit in Zahlen</translation>
    </message>
    <message>
        <source>Response of channel %1</source>
        <translation>Kennlinie von Kanal %1</translation>
    </message>
</context>
<context>
    <name>trex::CurveChip</name>
    <message>
        <source>Click to show or hide, drag to another plot, right button for colour, width and more</source>
        <translation>Klicken zeigt oder verbirgt, ziehen bringt in ein anderes Diagramm, rechte Taste für Farbe, Breite und mehr</translation>
    </message>
</context>
<context>
    <name>trex::DeviceSettings</name>
    <message>
        <source>%1: wrote %2, read back %3</source>
        <translation>%1: %2 geschrieben, %3 zurückgelesen</translation>
    </message>
    <message>
        <source>calibration of channel %1</source>
        <translation>Kalibrierung von Kanal %1</translation>
    </message>
    <message>
        <source>calibration of channel %1: %2</source>
        <translation>Kalibrierung von Kanal %1: %2</translation>
    </message>
    <message>
        <source>the controller (%1)</source>
        <translation>Controller (%1)</translation>
    </message>
    <message>
        <source>Stopped and disarmed before a setting is written: without CRC-7 a damaged packet could be heard as a motor order.</source>
        <translation>Vor dem Schreiben einer Einstellung angehalten und gesichert: Ohne CRC-7 könnte ein beschädigtes Paket als Motorbefehl verstanden werden.</translation>
    </message>
    <message>
        <source>%1 has its new value in force, which only a power cycle brings about</source>
        <translation>Für %1 gilt der neue Wert, was nur Aus- und Einschalten bewirkt</translation>
    </message>
</context>
<context>
    <name>trex::DifferencesDialog</name>
    <message>
        <source>Differences in %1</source>
        <translation>Unterschiede in %1</translation>
    </message>
    <message>
        <source>Leave out what should stay as it is in the controller. Nothing is written before Apply.</source>
        <translation>Abwählen, was im Controller bleiben soll, wie es ist. Geschrieben wird erst mit Übernehmen.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Eintragen</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>In controller</source>
        <translation>Im Controller</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>In der Datei</translation>
    </message>
    <message>
        <source>Take &amp;all</source>
        <translation>&amp;Alle wählen</translation>
    </message>
    <message>
        <source>Take &amp;none</source>
        <translation>&amp;Keine wählen</translation>
    </message>
    <message>
        <source>&amp;Keep these as edits</source>
        <translation>Diese &amp;eintragen</translation>
    </message>
    <message>
        <source>&amp;Leave all</source>
        <translation>Alles &amp;belassen</translation>
    </message>
    <message>
        <source>%1 of %2 are taken.</source>
        <translation>%1 von %2 gewählt.</translation>
    </message>
</context>
<context>
    <name>trex::DockTitle</name>
    <message>
        <source>Tear off or put back: %1</source>
        <translation>Ablösen oder andocken: %1</translation>
    </message>
    <message>
        <source>Close: %1</source>
        <translation>Schließen: %1</translation>
    </message>
</context>
<context>
    <name>trex::DrivePad</name>
    <message>
        <source>Hold and pull: up is forward, sideways turns. Or hold the arrow keys. Let go: both motors go to zero.</source>
        <translation>Halten und ziehen: oben ist vorwärts, seitwärts dreht. Oder die Pfeiltasten halten. Loslassen: beide Motoren gehen auf null.</translation>
    </message>
</context>
<context>
    <name>trex::EventList</name>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>%1 (%2 in a plot)</source>
        <translation>%1 (%2 in einem Diagramm)</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>Voriges Ereignis</translation>
    </message>
    <message>
        <source>Shift+N</source>
        <translation>Umschalt+N</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Nächstes Ereignis</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
</context>
<context>
    <name>trex::EventLog</name>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
</context>
<context>
    <name>trex::EventModel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
</context>
<context>
    <name>trex::FactoryResetDialog</name>
    <message>
        <source>All parameters in the controller go back to the factory&apos;s values. Calibrations stay.</source>
        <translation>Alle Parameter im Controller kehren auf die Werkseinstellungen zurück. Kalibrierungen bleiben.</translation>
    </message>
    <message>
        <source>First the whole configuration, calibrations included, is saved to a file, from which Load brings it back.</source>
        <translation>Zuerst wird die ganze Konfiguration samt Kalibrierungen in eine Datei gespeichert, aus der „Laden“ sie zurückholt.</translation>
    </message>
    <message>
        <source>The factory&apos;s values are in force after the controller&apos;s power was switched off and on.</source>
        <translation>Die Werkseinstellungen gelten, nachdem der Controller aus- und eingeschaltet wurde.</translation>
    </message>
    <message>
        <source>From then on the line is 19200 baud without error detection, one stop bit, device number 7: that is what to connect with.</source>
        <translation>Von da an gelten auf der Leitung 19200 Baud ohne Fehlererkennung, ein Stoppbit, Gerätenummer 7: damit verbinden.</translation>
    </message>
    <message>
        <source>≈ That parameter 0x7F with the value 0x7F does this was seen in use but is not stated by the vendor; that the values wait for the power cycle is inferred. What the controller holds afterwards is read from it.</source>
        <translation>≈ Dass Parameter 0x7F mit dem Wert 0x7F dies bewirkt, wurde im Gebrauch beobachtet, wird vom Hersteller aber nicht angegeben; dass die Werte auf das Aus- und Einschalten warten, ist gefolgert. Was der Controller danach enthält, wird aus ihm gelesen.</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Alle Parameter zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all parameters?</source>
        <translation>Alle Parameter zurücksetzen?</translation>
    </message>
    <message>
        <source>&amp;Yes, all parameters may be overwritten</source>
        <translation>&amp;Ja, alle Parameter dürfen überschrieben werden</translation>
    </message>
    <message>
        <source>&amp;Save, then reset</source>
        <translation>&amp;Speichern, dann zurücksetzen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>trex::HealthPanel</name>
    <message>
        <source>Advice about the line</source>
        <translation>Hinweise zur Leitung</translation>
    </message>
    <message>
        <source>How long answers took in the last minute</source>
        <translation>Wie lange Antworten in der letzten Minute brauchten</translation>
    </message>
    <message>
        <source>Count anew</source>
        <translation>Neu zählen</translation>
    </message>
    <message>
        <source>Count the figures of the line anew</source>
        <translation>Die Zahlen der Leitung neu zählen</translation>
    </message>
    <message>
        <source>Forgets the figures so far; what is counted begins now.</source>
        <translation>Vergisst die bisherigen Zahlen; gezählt wird ab jetzt.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy figures and advice as text</source>
        <translation>Zahlen und Hinweise als Text kopieren</translation>
    </message>
    <message>
        <source>Figures of the line</source>
        <translation>Zahlen der Leitung</translation>
    </message>
    <message>
        <source>last minute</source>
        <translation>letzte Minute</translation>
    </message>
    <message>
        <source>Counted since</source>
        <translation>Gezählt seit</translation>
    </message>
    <message>
        <source>in %1 s</source>
        <translation>in %1 s</translation>
    </message>
    <message>
        <source>in %1 min</source>
        <translation>in %1 min</translation>
    </message>
</context>
<context>
    <name>trex::Indicator</name>
    <message>
        <source>not known</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>lit</source>
        <translation>leuchtet</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message numerus="yes">
        <source>%1, seen %n time(s)</source>
        <translation>
            <numerusform>%1, %n-mal gesehen</numerusform>
            <numerusform>%1, %n-mal gesehen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::InterruptionWatch</name>
    <message>
        <source>No reading came for %1 s.</source>
        <translation>%1 s lang kam kein Messwert.</translation>
    </message>
    <message>
        <source>The computer was asleep, or this program stood still.</source>
        <translation>Der Computer war im Ruhezustand, oder dieses Programm stand still.</translation>
    </message>
    <message>
        <source>No fresh readings came from the controller for %1 s.</source>
        <translation>%1 s lang kamen keine neuen Messwerte vom Controller.</translation>
    </message>
</context>
<context>
    <name>trex::JournalDialog</name>
    <message>
        <source>Journal</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>&amp;Writes</source>
        <translation>Schreib&amp;vorgänge</translation>
    </message>
    <message>
        <source>&amp;Checkpoints</source>
        <translation>Sicherungs&amp;punkte</translation>
    </message>
    <message>
        <source>Why nothing can be written now</source>
        <translation>Warum jetzt nichts geschrieben werden kann</translation>
    </message>
    <message>
        <source>What happened last</source>
        <translation>Was zuletzt geschah</translation>
    </message>
    <message>
        <source>Search the journal</source>
        <translation>Journal durchsuchen</translation>
    </message>
    <message>
        <source>Search setting, value, result or time</source>
        <translation>Einstellung, Wert, Ergebnis oder Zeit suchen</translation>
    </message>
    <message>
        <source>Whose entries</source>
        <translation>Wessen Einträge</translation>
    </message>
    <message>
        <source>This controller</source>
        <translation>Dieser Controller</translation>
    </message>
    <message>
        <source>All controllers</source>
        <translation>Alle Controller</translation>
    </message>
    <message>
        <source>Writes, the newest first</source>
        <translation>Schreibvorgänge, neueste zuerst</translation>
    </message>
    <message>
        <source>&amp;Revert to before this…</source>
        <translation>Stand &amp;davor wiederherstellen…</translation>
    </message>
    <message>
        <source>List what has to be written so that the controller holds what it held before the chosen write</source>
        <translation>Auflisten, was zu schreiben ist, damit der Controller enthält, was er vor dem gewählten Schreibvorgang enthielt</translation>
    </message>
    <message>
        <source>Configurations that were kept</source>
        <translation>Festgehaltene Konfigurationen</translation>
    </message>
    <message>
        <source>Name of the checkpoint</source>
        <translation>Name des Sicherungspunkts</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>&amp;Keep as it is</source>
        <translation>&amp;Jetzigen Stand festhalten</translation>
    </message>
    <message>
        <source>Keep the controller&apos;s whole configuration under this name</source>
        <translation>Die ganze Konfiguration des Controllers unter diesem Namen festhalten</translation>
    </message>
    <message>
        <source>Re&amp;store…</source>
        <translation>&amp;Wiederherstellen…</translation>
    </message>
    <message>
        <source>List what has to be written so that the controller holds this</source>
        <translation>Auflisten, was zu schreiben ist, damit der Controller dies enthält</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Forget this checkpoint</source>
        <translation>Diesen Sicherungspunkt löschen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Save this checkpoint as a configuration file</source>
        <translation>Diesen Sicherungspunkt als Konfigurationsdatei speichern</translation>
    </message>
    <message>
        <source>What would be written</source>
        <translation>Was geschrieben würde</translation>
    </message>
    <message>
        <source>What will be written to the controller</source>
        <translation>Was in den Controller geschrieben wird</translation>
    </message>
    <message>
        <source>W&amp;rite these</source>
        <translation>Diese sch&amp;reiben</translation>
    </message>
    <message>
        <source>Write the list to the controller and read each value back</source>
        <translation>Die Liste in den Controller schreiben und jeden Wert zurücklesen</translation>
    </message>
    <message>
        <source>Write &amp;nothing</source>
        <translation>&amp;Nichts schreiben</translation>
    </message>
    <message>
        <source>Drop the list</source>
        <translation>Die Liste verwerfen</translation>
    </message>
    <message>
        <source>Not connected: the journal can be read, but nothing can be written.</source>
        <translation>Nicht verbunden: Das Journal ist lesbar, aber nichts kann geschrieben werden.</translation>
    </message>
    <message>
        <source>Waiting for the controller to tell its mode.</source>
        <translation>Warten, bis der Controller seinen Modus mitteilt.</translation>
    </message>
    <message>
        <source>▲ Nothing can be written: the controller is in %1 mode. Switch its power off, take the mode jumper off, and switch it on again.</source>
        <translation>▲ Nichts kann geschrieben werden: Der Controller ist im %1-Modus. Ausschalten, Modus-Steckbrücke abziehen und wieder einschalten.</translation>
    </message>
    <message>
        <source>RC</source>
        <translation>RC</translation>
    </message>
    <message>
        <source>analog</source>
        <translation>Analog</translation>
    </message>
    <message>
        <source>To hold what it held before %1 (%2), the controller needs:</source>
        <translation>Um zu enthalten, was er vor %1 (%2) enthielt, braucht der Controller:</translation>
    </message>
    <message>
        <source>To hold the configuration of %1, the controller needs:</source>
        <translation>Um die Konfiguration vom %1 zu enthalten, braucht der Controller:</translation>
    </message>
    <message>
        <source>Reading everything from the controller.</source>
        <translation>Lesen aller Einstellungen aus dem Controller.</translation>
    </message>
    <message>
        <source>%1 (acts after a power cycle)</source>
        <translation>%1 (wirkt nach Aus- und Einschalten)</translation>
    </message>
    <message>
        <source>Nothing: it holds all of that already.</source>
        <translation>Nichts: Er enthält all das bereits.</translation>
    </message>
    <message>
        <source>Writing to the controller.</source>
        <translation>Schreiben in den Controller.</translation>
    </message>
    <message>
        <source>The configuration is kept as %1.</source>
        <translation>Die Konfiguration ist als %1 festgehalten.</translation>
    </message>
    <message>
        <source>The checkpoint %1 is deleted.</source>
        <translation>Der Sicherungspunkt %1 ist gelöscht.</translation>
    </message>
    <message>
        <source>Export the checkpoint</source>
        <translation>Sicherungspunkt exportieren</translation>
    </message>
    <message>
        <source>Configuration (*.json)</source>
        <translation>Konfiguration (*.json)</translation>
    </message>
    <message>
        <source>The checkpoint is saved in %1.</source>
        <translation>Der Sicherungspunkt ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Journal…</source>
        <translation>&amp;Journal…</translation>
    </message>
    <message>
        <source>Not connected. Choose &quot;All controllers&quot; to read the journal.</source>
        <translation>Nicht verbunden. „Alle Regler“ wählen, um das Journal zu lesen.</translation>
    </message>
</context>
<context>
    <name>trex::JournalModel</name>
    <message>
        <source>Entry %1, written by %2 to %3</source>
        <translation>Eintrag %1, von %2 in %3 geschrieben</translation>
    </message>
    <message>
        <source>Packet %1</source>
        <translation>Paket %1</translation>
    </message>
    <message>
        <source>Found out %1</source>
        <translation>Festgestellt %1</translation>
    </message>
    <message>
        <source>not asked who it is</source>
        <translation>nicht nach Signatur gefragt</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controller</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Old → new</source>
        <translation>Alt → neu</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>trex::LatencyView</name>
    <message>
        <source>How long answers took</source>
        <translation>Wie lange Antworten brauchten</translation>
    </message>
    <message>
        <source>%1 answers: half within %2 ms, 99 of 100 within %3 ms, the longest %4 ms; the wire alone %5 ms.</source>
        <translation>%1 Antworten: die Hälfte innerhalb von %2 ms, 99 von 100 innerhalb von %3 ms, die längste %4 ms; die Leitung allein %5 ms.</translation>
    </message>
    <message>
        <source>No answers yet. Connect, and every answer is counted here.</source>
        <translation>Noch keine Antworten. Sobald eine Verbindung besteht, wird hier jede Antwort gezählt.</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>half within %1 ms</source>
        <translation>Hälfte in %1 ms</translation>
    </message>
    <message>
        <source>99 % within %1 ms</source>
        <translation>99 % in %1 ms</translation>
    </message>
    <message>
        <source>longest %1 ms</source>
        <translation>längste %1 ms</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>wire alone</source>
        <translation>Leitung allein</translation>
    </message>
    <message>
        <source>%1 to %2 ms: %3 answers; the wire alone: %4</source>
        <translation>%1 bis %2 ms: %3 Antworten; die Leitung allein: %4</translation>
    </message>
</context>
<context>
    <name>trex::LineChange</name>
    <message>
        <source>Waiting for the power cycle: switch the controller off and on. From then on it answers with %1; the connection follows by itself.</source>
        <translation>Warten auf das Aus- und Einschalten: den Controller aus- und einschalten. Von da an antwortet er mit %1; die Verbindung folgt von selbst.</translation>
    </message>
    <message>
        <source>The line settings change at the next power cycle, to %1.</source>
        <translation>Die Leitungseinstellungen wechseln beim nächsten Aus- und Einschalten zu %1.</translation>
    </message>
    <message>
        <source>The controller is silent. Looking for it with %1…</source>
        <translation>Der Controller schweigt. Suche mit %1…</translation>
    </message>
    <message>
        <source>The controller answers neither with the new settings nor with the old.</source>
        <translation>Der Controller antwortet weder mit den neuen noch mit den alten Einstellungen.</translation>
    </message>
    <message>
        <source>Searching: %1 (%2 of %3).</source>
        <translation>Suche: %1 (%2 von %3).</translation>
    </message>
    <message>
        <source>The controller answers neither with %1 nor with %2. Searching for it…</source>
        <translation>Der Controller antwortet weder mit %1 noch mit %2. Er wird gesucht…</translation>
    </message>
    <message>
        <source>No controller was found after the change of its line settings. %1 %2</source>
        <translation>Nach der Änderung seiner Leitungseinstellungen wurde der Controller nicht gefunden. %1 %2</translation>
    </message>
    <message>
        <source>The controller answers with %1.</source>
        <translation>Der Controller antwortet mit %1.</translation>
    </message>
    <message>
        <source>The controller still answers with the old settings, %1. Switch it off and on; from then on it answers with %2.</source>
        <translation>Der Controller antwortet noch mit den alten Einstellungen, %1. Aus- und einschalten; von da an antwortet er mit %2.</translation>
    </message>
    <message>
        <source>its new line settings are in force</source>
        <translation>seine neuen Leitungseinstellungen gelten</translation>
    </message>
    <message>
        <source>%1 It was asked to use %2.</source>
        <translation>%1 Verlangt war %2.</translation>
    </message>
</context>
<context>
    <name>trex::LineChangeBox</name>
    <message>
        <source>Change of the line settings</source>
        <translation>Änderung der Leitungseinstellungen</translation>
    </message>
    <message>
        <source>Reconnect &amp;now</source>
        <translation>Jetzt &amp;neu verbinden</translation>
    </message>
    <message>
        <source>Search no&amp;w</source>
        <translation>Jetzt s&amp;uchen</translation>
    </message>
    <message>
        <source>Canc&amp;el</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Looks for the controller at once, with its new line settings and its old ones.</source>
        <translation>Sucht den Regler sofort, mit seinen neuen und seinen alten Leitungseinstellungen.</translation>
    </message>
    <message>
        <source>Tries every baud rate and error detection on this port.</source>
        <translation>Versucht jede Baudrate und jede Fehlererkennung an diesem Anschluss.</translation>
    </message>
    <message>
        <source>Waits no longer. What is stored in the controller stays.</source>
        <translation>Wartet nicht länger. Was im Regler gespeichert ist, bleibt.</translation>
    </message>
</context>
<context>
    <name>trex::LineForm</name>
    <message>
        <source>Rarely changed</source>
        <translation>Selten geändert</translation>
    </message>
    <message>
        <source>&amp;Baud rate</source>
        <translation>&amp;Baudrate</translation>
    </message>
    <message>
        <source>As set in the controller; it leaves the factory with 19200.</source>
        <translation>Wie im Controller eingestellt; ab Werk 19200.</translation>
    </message>
    <message>
        <source>&amp;Error detection</source>
        <translation>Fehlerer&amp;kennung</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Even parity</source>
        <translation>Gerade Parität</translation>
    </message>
    <message>
        <source>Odd parity</source>
        <translation>Ungerade Parität</translation>
    </message>
    <message>
        <source>CRC-7</source>
        <translation>CRC-7</translation>
    </message>
    <message>
        <source>As set in the controller; it leaves the factory with none.</source>
        <translation>Wie im Controller eingestellt; ab Werk keine.</translation>
    </message>
    <message>
        <source>Packet &amp;form</source>
        <translation>Paketfor&amp;m</translation>
    </message>
    <message>
        <source>Compact</source>
        <translation>Kompakt</translation>
    </message>
    <message>
        <source>Pololu</source>
        <translation>Pololu</translation>
    </message>
    <message>
        <source>The controller understands both. Pololu packets name the device, for several on one line.</source>
        <translation>Der Controller versteht beide. Pololu-Pakete nennen das Gerät, für mehrere an einer Leitung.</translation>
    </message>
    <message>
        <source>Device &amp;number</source>
        <translation>&amp;Gerätenummer</translation>
    </message>
    <message>
        <source>Only packets in the Pololu form carry it.</source>
        <translation>Nur Pakete in der Pololu-Form enthalten sie.</translation>
    </message>
    <message>
        <source>Of CRC-7, most significant bit set; 0x89 unless changed.</source>
        <translation>Für CRC-7, höchstes Bit gesetzt; 0x89, sofern nicht geändert.</translation>
    </message>
    <message>
        <source>CRC &amp;polynomial</source>
        <translation>CRC-Pol&amp;ynom</translation>
    </message>
    <message>
        <source>St&amp;op bits</source>
        <translation>Stoppb&amp;its</translation>
    </message>
    <message>
        <source>Ec&amp;ho</source>
        <translation>Ech&amp;o</translation>
    </message>
    <message>
        <source>Found out</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Line echoes</source>
        <translation>Mit Echo</translation>
    </message>
    <message>
        <source>No echo</source>
        <translation>Ohne Echo</translation>
    </message>
    <message>
        <source>RS-232 wiring brings back what is sent; those bytes are dropped.</source>
        <translation>RS-232-Verkabelung bringt Gesendetes zurück; diese Bytes werden verworfen.</translation>
    </message>
    <message>
        <source>Reply &amp;timeout</source>
        <translation>Antwo&amp;rtfrist</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>How long to wait for a reply, above its time on the wire.</source>
        <translation>Wartezeit auf eine Antwort, über die Übertragungszeit hinaus.</translation>
    </message>
</context>
<context>
    <name>trex::LinkStatusBar</name>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>verbindet</translation>
    </message>
    <message>
        <source>link lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>link lost, trying again</source>
        <translation>Verbindung verloren, neuer Versuch</translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation>getrennt</translation>
    </message>
    <message>
        <source>State of the link</source>
        <translation>Zustand der Verbindung</translation>
    </message>
    <message>
        <source>Transactions a second</source>
        <translation>Transaktionen je Sekunde</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Umlaufzeit</translation>
    </message>
    <message>
        <source>Errors of the link</source>
        <translation>Fehler der Verbindung</translation>
    </message>
    <message>
        <source>Rates that the line allows</source>
        <translation>Von der Leitung zugelassene Raten</translation>
    </message>
    <message>
        <source>%1 transactions/s</source>
        <translation>%1 Transaktionen/s</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n Fehler</numerusform>
            <numerusform>%n Fehler</numerusform>
        </translation>
    </message>
    <message>
        <source>No reply in time: %1
Reply failed its CRC: %2
Implausible reply: %3
Asked again: %4
Late or foreign bytes dropped: %5</source>
        <translation>Keine Antwort rechtzeitig: %1
Antwort mit CRC-Fehler: %2
Unplausible Antwort: %3
Erneut gefragt: %4
Verspätete oder fremde Bytes verworfen: %5</translation>
    </message>
    <message>
        <source>line too slow: %1 %2 of %3 Hz</source>
        <translation>Leitung zu langsam: %1 %2 von %3 Hz</translation>
    </message>
</context>
<context>
    <name>trex::LogPanel</name>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the log</source>
        <translation>Protokoll kopieren</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save the log</source>
        <translation>Protokoll speichern</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Text (*.txt)</translation>
    </message>
    <message>
        <source>Log saved to %1.</source>
        <translation>Protokoll in %1 gespeichert.</translation>
    </message>
    <message>
        <source>The log could not be saved to %1: %2. Choose another place.</source>
        <translation>Das Protokoll konnte nicht in %1 gespeichert werden: %2. Anderen Ort wählen.</translation>
    </message>
</context>
<context>
    <name>trex::MainWindow</name>
    <message>
        <source>TReX Panel</source>
        <translation>TReX Panel</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Put all panels back</source>
        <translation>Alle Bereiche zurückstellen</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>About and licences</source>
        <translation>Info und Lizenzen</translation>
    </message>
</context>
<context>
    <name>trex::MarkKeeper</name>
    <message>
        <source>Motor 1 over its current limit</source>
        <translation>Motor 1 über seiner Stromgrenze</translation>
    </message>
    <message>
        <source>Motor 2 over its current limit</source>
        <translation>Motor 2 über seiner Stromgrenze</translation>
    </message>
    <message>
        <source>Motor 1 fault</source>
        <translation>Motor 1: Fehler</translation>
    </message>
    <message>
        <source>Motor 2 fault</source>
        <translation>Motor 2: Fehler</translation>
    </message>
    <message>
        <source>Serial timeout in the controller</source>
        <translation>Serielle Zeitüberschreitung im Controller</translation>
    </message>
    <message>
        <source>UART error: packet format</source>
        <translation>UART-Fehler: Paketformat</translation>
    </message>
    <message>
        <source>UART error: CRC</source>
        <translation>UART-Fehler: CRC</translation>
    </message>
    <message>
        <source>UART error: frame</source>
        <translation>UART-Fehler: Rahmen</translation>
    </message>
    <message>
        <source>UART error: data overrun</source>
        <translation>UART-Fehler: Datenüberlauf</translation>
    </message>
    <message>
        <source>UART error: parity</source>
        <translation>UART-Fehler: Parität</translation>
    </message>
    <message>
        <source>UART error: read buffer overrun</source>
        <translation>UART-Fehler: Überlauf des Empfangspuffers</translation>
    </message>
    <message>
        <source>UART error: send buffer overrun</source>
        <translation>UART-Fehler: Überlauf des Sendepuffers</translation>
    </message>
    <message>
        <source>Link back</source>
        <translation>Verbindung wieder da</translation>
    </message>
    <message>
        <source>Link lost: %1</source>
        <translation>Verbindung verloren: %1</translation>
    </message>
    <message>
        <source>Factory reset</source>
        <translation>Auf Werkseinstellungen gesetzt</translation>
    </message>
    <message>
        <source>%1 (not read back)</source>
        <translation>%1 (nicht zurückgelesen)</translation>
    </message>
</context>
<context>
    <name>trex::MeasurementModel</name>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektiv</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Charge</source>
        <translation>Ladung</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Messwerte</translation>
    </message>
</context>
<context>
    <name>trex::MeasurementView</name>
    <message>
        <source>Times of the cursors</source>
        <translation>Zeiten der Cursor</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>Werte an den Cursorn</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Tabelle kopieren</translation>
    </message>
    <message>
        <source>Copy the table, for a spreadsheet</source>
        <translation>Die Tabelle kopieren, für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Remove the cursors</source>
        <translation>Cursor entfernen</translation>
    </message>
</context>
<context>
    <name>trex::MotorRow</name>
    <message>
        <source>%1 speed</source>
        <translation>Drehzahl %1</translation>
    </message>
    <message>
        <source>%1 commanded speed</source>
        <translation>Befohlene Drehzahl %1</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Null</translation>
    </message>
    <message>
        <source>%1 to zero</source>
        <translation>%1 auf null</translation>
    </message>
    <message>
        <source>Arrow keys: one step. Page keys: eight. Space or Home: zero.</source>
        <translation>Pfeiltasten: ein Schritt. Bildtasten: acht. Leertaste oder Pos1: null.</translation>
    </message>
    <message>
        <source>%1 braking duty</source>
        <translation>Bremsgrad %1</translation>
    </message>
    <message>
        <source>Braking duty: 0 coasts, 127 brakes fully.</source>
        <translation>Bremsgrad: 0 lässt auslaufen, 127 bremst voll.</translation>
    </message>
    <message>
        <source>Brake</source>
        <translation>Bremsen</translation>
    </message>
    <message>
        <source>Brake %1</source>
        <translation>%1 bremsen</translation>
    </message>
    <message>
        <source>brake %1</source>
        <translation>Bremse %1</translation>
    </message>
    <message>
        <source>%1 reverse while held</source>
        <translation>%1 rückwärts, solange gehalten</translation>
    </message>
    <message>
        <source>%1 forward while held</source>
        <translation>%1 vorwärts, solange gehalten</translation>
    </message>
</context>
<context>
    <name>trex::MotorsPanel</name>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Arm the motors</source>
        <translation>Motoren scharf schalten</translation>
    </message>
    <message>
        <source>Stop all motors</source>
        <translation>Alle Motoren anhalten</translation>
    </message>
    <message>
        <source>How a speed is reached</source>
        <translation>Wie eine Drehzahl erreicht wird</translation>
    </message>
    <message>
        <source>Set at once</source>
        <translation>Sofort setzen</translation>
    </message>
    <message>
        <source>Accelerate</source>
        <translation>Beschleunigen</translation>
    </message>
    <message>
        <source>Link 1 and 2</source>
        <translation>1 und 2 koppeln</translation>
    </message>
    <message>
        <source>Move both motors together</source>
        <translation>Beide Motoren gemeinsam bewegen</translation>
    </message>
    <message>
        <source>What orders do</source>
        <translation>Was Befehle bewirken</translation>
    </message>
    <message>
        <source>Motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>Motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>Auxiliary motor</source>
        <translation>Hilfsmotor</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Serial does not control the motors now: an order waits in the controller and acts the moment serial override starts.</source>
        <translation>Die Motoren werden jetzt nicht seriell gesteuert: Ein Befehl wartet im Controller und wirkt, sobald die serielle Übernahme beginnt.</translation>
    </message>
    <message>
        <source>Joint mode: motor 1 orders drive both H-bridges; motor 2 has none.</source>
        <translation>Gemeinsamer Modus: Befehle für Motor 1 steuern beide H-Brücken; Motor 2 hat keine.</translation>
    </message>
    <message>
        <source>Accelerate keeps to the acceleration, brake duration and current limit parameters.</source>
        <translation>Beschleunigen hält die Parameter für Beschleunigung, Bremsdauer und Stromgrenze ein.</translation>
    </message>
    <message>
        <source>Set acts at once and overrides current limiting for the moment.</source>
        <translation>Setzen wirkt sofort und übergeht vorübergehend die Strombegrenzung.</translation>
    </message>
    <message>
        <source>Hold to run</source>
        <translation>Nur gehalten fahren</translation>
    </message>
    <message>
        <source>Motors run only while a control is held</source>
        <translation>Motoren laufen nur, solange ein Bedienelement gehalten wird</translation>
    </message>
    <message>
        <source>A slider springs to zero when it is let go, loses the focus, or its window goes behind another.</source>
        <translation>Ein Schieber springt auf null, wenn er losgelassen wird, den Fokus verliert oder sein Fenster hinter ein anderes gerät.</translation>
    </message>
    <message>
        <source>Drive pad</source>
        <translation>Fahrfeld</translation>
    </message>
    <message>
        <source>Show the drive pad</source>
        <translation>Fahrfeld anzeigen</translation>
    </message>
    <message>
        <source>Drives both motors like one stick, in place of their sliders.</source>
        <translation>Fährt beide Motoren wie mit einem Knüppel, anstelle ihrer Schieber.</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>More about the motors</source>
        <translation>Mehr zu den Motoren</translation>
    </message>
    <message>
        <source>Safety and limits…</source>
        <translation>Sicherheit und Grenzen…</translation>
    </message>
    <message>
        <source>Watchdog proof…</source>
        <translation>Nachweis der Zeitüberwachung…</translation>
    </message>
    <message>
        <source>Drive pad: hold and pull, or hold the arrow keys</source>
        <translation>Fahrfeld: halten und ziehen, oder die Pfeiltasten halten</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>Sliders</source>
        <translation>Schieber</translation>
    </message>
    <message>
        <source>%1: hold a shoulder button and pull the left stick.</source>
        <translation>%1: Schultertaste halten und den linken Stick bewegen.</translation>
    </message>
    <message>
        <source>Of the recording: the sliders show what was sent then.</source>
        <translation>Aus der Aufzeichnung: Die Regler zeigen, was damals gesendet wurde.</translation>
    </message>
</context>
<context>
    <name>trex::PacketComposer</name>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>S&amp;end</source>
        <translation>S&amp;enden</translation>
    </message>
    <message>
        <source>Send the packet</source>
        <translation>Paket senden</translation>
    </message>
    <message>
        <source>The packet as it will be sent</source>
        <translation>Das Paket, wie es gesendet wird</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Motor 2 direction</source>
        <translation>Richtung Motor 2</translation>
    </message>
    <message>
        <source>Bytes in hex</source>
        <translation>Bytes hexadezimal</translation>
    </message>
    <message>
        <source>Reply bytes</source>
        <translation>Antwortbytes</translation>
    </message>
    <message>
        <source>How many bytes to wait for, the CRC byte not counted.</source>
        <translation>Anzahl der erwarteten Bytes, ohne CRC-Byte.</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Brake</source>
        <translation>Bremsen</translation>
    </message>
    <message>
        <source>Raw bytes (hex)</source>
        <translation>Rohe Bytes (hex)</translation>
    </message>
    <message>
        <source>Motor 1 direction</source>
        <translation>Richtung Motor 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>The sum of 1, 2, 4, 8 and 16 for channels 1 to 5.</source>
        <translation>Die Summe aus 1, 2, 4, 8 und 16 für die Kanäle 1 bis 5.</translation>
    </message>
    <message>
        <source>Sends %1, as given.</source>
        <translation>Sendet %1, wie angegeben.</translation>
    </message>
    <message>
        <source>Sends the bytes as given, without packet form and CRC.</source>
        <translation>Sendet die Bytes wie angegeben, ohne Paketform und CRC.</translation>
    </message>
    <message>
        <source>Sends %1: %2</source>
        <translation>Sendet %1: %2</translation>
    </message>
    <message>
        <source>Nothing was sent: give the bytes in hex, such as 86 1F.</source>
        <translation>Nichts wurde gesendet: Bytes hexadezimal angeben, etwa 86 1F.</translation>
    </message>
    <message>
        <source>Nothing was sent: &quot;%1&quot; is not bytes in hex, such as 86 1F.</source>
        <translation>Nichts wurde gesendet: „%1“ sind keine hexadezimalen Bytes, etwa 86 1F.</translation>
    </message>
    <message>
        <source>Sent %1; no reply is due.</source>
        <translation>%1 gesendet; keine Antwort vorgesehen.</translation>
    </message>
    <message>
        <source>Received %1 after %2 ms</source>
        <translation>%1 nach %2 ms empfangen</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>trex::PacketEntry</name>
    <message>
        <source>Raw bytes</source>
        <translation>Rohe Bytes</translation>
    </message>
    <message>
        <source>Raw: %1</source>
        <translation>Roh: %1</translation>
    </message>
    <message>
        <source>attempt %1</source>
        <translation>Versuch %1</translation>
    </message>
</context>
<context>
    <name>trex::PacketModel</name>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Gesendet</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Empfangen</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Round trip (ms)</source>
        <translation>Umlaufzeit (ms)</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
</context>
<context>
    <name>trex::PacketsPanel</name>
    <message>
        <source>All packets</source>
        <translation>Alle Pakete</translation>
    </message>
    <message>
        <source>Motor commands</source>
        <translation>Motorbefehle</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Queries asked for</source>
        <translation>Einzelabfragen</translation>
    </message>
    <message>
        <source>Polls</source>
        <translation>Laufende Abfragen</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Filter the packets</source>
        <translation>Pakete filtern</translation>
    </message>
    <message>
        <source>Filter by meaning, hex or key</source>
        <translation>Nach Bedeutung, Hex oder Schlüssel filtern</translation>
    </message>
    <message>
        <source>Kind of packets shown</source>
        <translation>Art der gezeigten Pakete</translation>
    </message>
    <message>
        <source>Pause the list</source>
        <translation>Liste anhalten</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Hold the list still; recording goes on behind</source>
        <translation>Liste anhalten; die Aufzeichnung läuft im Hintergrund weiter</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Packets</source>
        <translation>Pakete</translation>
    </message>
    <message>
        <source>Counts of packets</source>
        <translation>Anzahl der Pakete</translation>
    </message>
    <message>
        <source>%1 of %2 packets shown</source>
        <translation>%1 von %2 Paketen gezeigt</translation>
    </message>
    <message>
        <source>paused, %1 more recorded</source>
        <translation>angehalten, %1 weitere aufgezeichnet</translation>
    </message>
    <message>
        <source>the oldest %1 were dropped</source>
        <translation>die ältesten %1 verworfen</translation>
    </message>
</context>
<context>
    <name>trex::ParameterModel</name>
    <message>
        <source>Stored, but not in force before the controller&apos;s power is switched off and on.</source>
        <translation>Gespeichert, gilt aber erst nach dem Aus- und Einschalten des Controllers.</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>nicht gelesen</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>In controller</source>
        <translation>Im Controller</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>not default</source>
        <translation>abweichend</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>power cycle</source>
        <translation>Aus/Ein nötig</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>bearbeitet</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>How sure</source>
        <translation>Wie sicher</translation>
    </message>
    <message>
        <source>≈ default</source>
        <translation>≈ Standard</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Meaning: %1. Default: %2.</source>
        <translation>Bedeutung: %1. Standard: %2.</translation>
    </message>
    <message>
        <source>≈ The scale in amperes is inferred for the TReX.</source>
        <translation>≈ Die Skala in Ampere ist für den TReX gefolgert.</translation>
    </message>
    <message>
        <source>edited ▲</source>
        <translation>geändert ▲</translation>
    </message>
    <message>
        <source>%1 · in controller: %2 · default: %3</source>
        <translation>%1 · im Controller: %2 · Standard: %3</translation>
    </message>
</context>
<context>
    <name>trex::ParameterTable</name>
    <message>
        <source>power cycle</source>
        <translation>Aus/Ein nötig</translation>
    </message>
    <message>
        <source>channels 1, 2, 3 (00)</source>
        <translation>Kanäle 1, 2, 3 (00)</translation>
    </message>
    <message>
        <source>channels 1 to 5</source>
        <translation>Kanäle 1 bis 5</translation>
    </message>
    <message>
        <source>This controller did not tell its value of this parameter.</source>
        <translation>Dieser Controller hat seinen Wert für diesen Parameter nicht mitgeteilt.</translation>
    </message>
</context>
<context>
    <name>trex::ParametersPanel</name>
    <message>
        <source>The connection is lost: values are unknown until it is back. Your edits are kept.</source>
        <translation>Die Verbindung ist verloren: Werte sind unbekannt, bis sie wieder da ist. Änderungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>Not connected. Connect to read the controller&apos;s parameters.</source>
        <translation>Nicht verbunden. Verbinden, um die Parameter des Controllers zu lesen.</translation>
    </message>
    <message>
        <source>Writing to the controller.</source>
        <translation>Schreiben in den Controller.</translation>
    </message>
    <message>
        <source>Reading all parameters from the controller.</source>
        <translation>Lesen aller Parameter aus dem Controller.</translation>
    </message>
    <message>
        <source>Waiting for the controller to tell its mode.</source>
        <translation>Warten, bis der Controller seinen Modus mitteilt.</translation>
    </message>
    <message>
        <source>These can be read but not changed: the controller is in %1 mode. Switch its power off, take the mode jumper off, and switch it on again.</source>
        <translation>Lesbar, aber nicht änderbar: Der Controller ist im %1-Modus. Ausschalten, Modus-Steckbrücke abziehen und wieder einschalten.</translation>
    </message>
    <message>
        <source>RC</source>
        <translation>RC</translation>
    </message>
    <message>
        <source>analog</source>
        <translation>Analog</translation>
    </message>
    <message>
        <source>Needs a power cycle: switch the controller off and on to put in force: %1.</source>
        <translation>Aus- und Einschalten des Controllers nötig; erst danach gilt: %1.</translation>
    </message>
    <message>
        <source>Nothing is written to the controller, because the present settings could not be saved first: %1 Apply once more to write without that copy.</source>
        <translation>Nichts wird in den Controller geschrieben, weil die jetzigen Einstellungen vorher nicht gespeichert werden konnten: %1 Nochmals Übernehmen drücken, um ohne diese Kopie zu schreiben.</translation>
    </message>
    <message>
        <source>The settings as they were are saved in %1.</source>
        <translation>Die bisherigen Einstellungen sind in %1 gespeichert.</translation>
    </message>
    <message>
        <source>The factory defaults are filled in; nothing is written before Apply.</source>
        <translation>Die Werkseinstellungen sind eingetragen; geschrieben wird erst mit Übernehmen.</translation>
    </message>
    <message>
        <source>Of the values that would change, %1 are marked ≈: the vendor does not state them, they are guesses.</source>
        <translation>Von den Werten, die sich ändern würden, sind %1 mit ≈ markiert: Der Hersteller gibt sie nicht an, sie sind vermutet.</translation>
    </message>
    <message>
        <source>Save the controller&apos;s settings</source>
        <translation>Einstellungen des Controllers speichern</translation>
    </message>
    <message>
        <source>Configuration (*.json)</source>
        <translation>Konfiguration (*.json)</translation>
    </message>
    <message>
        <source>Nothing is saved: not all settings are read from the controller. Reload, then save again.</source>
        <translation>Nichts gespeichert: Nicht alle Einstellungen sind aus dem Controller gelesen. Neu lesen, dann erneut speichern.</translation>
    </message>
    <message>
        <source>What is in the controller is saved in %1.</source>
        <translation>Der Inhalt des Controllers ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source>What is in the controller is saved in %1; edits that are not applied are not in it.</source>
        <translation>Der Inhalt des Controllers ist in %1 gespeichert; nicht übernommene Änderungen sind nicht enthalten.</translation>
    </message>
    <message>
        <source>Load settings</source>
        <translation>Einstellungen laden</translation>
    </message>
    <message>
        <source>%1 says what is in the controller already.</source>
        <translation>%1 entspricht bereits dem Inhalt des Controllers.</translation>
    </message>
    <message>
        <source>%1 is filled in; nothing is written before Apply.</source>
        <translation>%1 ist eingetragen; geschrieben wird erst mit Übernehmen.</translation>
    </message>
    <message>
        <source>Left out, since this controller does not have them: %1.</source>
        <translation>Ausgelassen, da dieser Controller sie nicht hat: %1.</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Parameter suchen</translation>
    </message>
    <message>
        <source>Search name, key, number or help</source>
        <translation>Name, Schlüssel, Nummer oder Hilfe suchen</translation>
    </message>
    <message>
        <source>Re&amp;load</source>
        <translation>&amp;Neu lesen</translation>
    </message>
    <message>
        <source>Read everything from the controller again; edits stay</source>
        <translation>Alles erneut aus dem Controller lesen; Änderungen bleiben</translation>
    </message>
    <message>
        <source>&amp;Defaults</source>
        <translation>Standa&amp;rd</translation>
    </message>
    <message>
        <source>Fill in the factory defaults; nothing is written before Apply</source>
        <translation>Werkseinstellungen eintragen; geschrieben wird erst mit Übernehmen</translation>
    </message>
    <message>
        <source>Loa&amp;d…</source>
        <translation>&amp;Laden…</translation>
    </message>
    <message>
        <source>Fill in the values of a file; nothing is written before Apply</source>
        <translation>Werte einer Datei eintragen; geschrieben wird erst mit Übernehmen</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>Spei&amp;chern…</translation>
    </message>
    <message>
        <source>Save what is in the controller to a file</source>
        <translation>Inhalt des Controllers in eine Datei speichern</translation>
    </message>
    <message>
        <source>State of the parameters</source>
        <translation>Zustand der Parameter</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Help on the parameter</source>
        <translation>Hilfe zum Parameter</translation>
    </message>
    <message>
        <source>What happened last</source>
        <translation>Was zuletzt geschah</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Revert</source>
        <translation>Ver&amp;werfen</translation>
    </message>
    <message>
        <source>Drop all edits</source>
        <translation>Alle Änderungen verwerfen</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>Ü&amp;bernehmen</translation>
    </message>
    <message>
        <source>Write what differs to the controller now and read it back</source>
        <translation>Abweichendes jetzt in den Controller schreiben und zurücklesen</translation>
    </message>
    <message>
        <source>Put &amp;back 1 value</source>
        <translation>1 Wert &amp;zurückschreiben</translation>
    </message>
    <message>
        <source>Put &amp;back %1 values</source>
        <translation>%1 Werte &amp;zurückschreiben</translation>
    </message>
    <message>
        <source>What you wanted stands as an edit again.</source>
        <translation>Das Gewünschte steht wieder als Änderung da.</translation>
    </message>
    <message>
        <source>Put it back, or keep it?</source>
        <translation>Zurückschreiben oder behalten?</translation>
    </message>
    <message>
        <source>Nothing is reset. %1</source>
        <translation>Nichts wird zurückgesetzt. %1</translation>
    </message>
    <message>
        <source>Nothing is reset, because the present settings could not be saved first: %1</source>
        <translation>Nichts wird zurückgesetzt, weil die jetzigen Einstellungen vorher nicht gespeichert werden konnten: %1</translation>
    </message>
    <message>
        <source>Resetting all parameters: %1 The settings are saved in %2.</source>
        <translation>Alle Parameter werden zurückgesetzt: %1 Die Einstellungen sind in %2 gespeichert.</translation>
    </message>
    <message>
        <source>The controller has taken the order to reset all parameters. Switch its power off and on; then it answers at 19200 baud without error detection, device number 7. The settings before are saved in %1.</source>
        <translation>Der Controller hat den Befehl angenommen, alle Parameter zurückzusetzen. Aus- und einschalten; dann antwortet er mit 19200 Baud ohne Fehlererkennung, Gerätenummer 7. Die bisherigen Einstellungen sind in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>Welche Parameter</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Geändert</translation>
    </message>
    <message>
        <source>Not default</source>
        <translation>Abweichend</translation>
    </message>
    <message>
        <source>&amp;More</source>
        <translation>&amp;Mehr</translation>
    </message>
    <message>
        <source>What is not needed every day</source>
        <translation>Was nicht jeden Tag gebraucht wird</translation>
    </message>
    <message>
        <source>&amp;Compare settings…</source>
        <translation>Einstellungen &amp;vergleichen…</translation>
    </message>
    <message>
        <source>Reset to &amp;factory defaults…</source>
        <translation>Auf &amp;Werkseinstellungen zurücksetzen…</translation>
    </message>
    <message>
        <source>No parameter is shown</source>
        <translation>Kein Parameter wird gezeigt</translation>
    </message>
    <message>
        <source>No parameter is found. Clear the search to see all.</source>
        <translation>Kein Parameter gefunden. Die Suche leeren, um alle zu sehen.</translation>
    </message>
    <message>
        <source>No parameter is found: &quot;%1&quot; is chosen beside the search.</source>
        <translation>Kein Parameter gefunden: Neben der Suche ist „%1“ gewählt.</translation>
    </message>
    <message>
        <source>%v of %m</source>
        <translation>%v von %m</translation>
    </message>
    <message>
        <source>Stop writing after the setting that is being written now</source>
        <translation>Das Schreiben nach der Einstellung beenden, die gerade geschrieben wird</translation>
    </message>
    <message>
        <source>Write the values back that the controller had before</source>
        <translation>Die Werte zurückschreiben, die der Controller zuvor hatte</translation>
    </message>
    <message>
        <source>&amp;Keep them</source>
        <translation>B&amp;ehalten</translation>
    </message>
    <message>
        <source>Leave what was written as it is in the controller</source>
        <translation>Das Geschriebene im Controller belassen, wie es ist</translation>
    </message>
    <message>
        <source>What was written stays in the controller.</source>
        <translation>Das Geschriebene bleibt im Controller.</translation>
    </message>
    <message>
        <source>Power cycle</source>
        <translation>Aus-/Einschalten</translation>
    </message>
    <message>
        <source>Which parameters are shown: all, those with edits, those that are not as from the factory, or those that need a power cycle</source>
        <translation>Welche Parameter gezeigt werden: alle, die geänderten, die nicht wie ab Werk sind, oder die ein Aus- und Einschalten brauchen</translation>
    </message>
    <message>
        <source>&amp;Journal of writes…</source>
        <translation>&amp;Journal der Schreibvorgänge …</translation>
    </message>
    <message>
        <source>These are the settings as they were read during the recording; they cannot be changed here. Save them to a file, and load that file into a controller.</source>
        <translation>Dies sind die Einstellungen, wie sie während der Aufzeichnung gelesen wurden; hier können sie nicht geändert werden. Sichern Sie sie in eine Datei, und laden Sie diese in einen Controller.</translation>
    </message>
    <message>
        <source>All parameters were ordered to be reset before the restart; the table shows what the controller holds now. The settings before are saved in %1.</source>
        <translation>Vor dem Neustart wurde befohlen, alle Parameter zurückzusetzen; die Tabelle zeigt, was der Controller jetzt enthält. Die vorherigen Einstellungen sind in %1 gesichert.</translation>
    </message>
    <message>
        <source>Nothing is written to the controller, because the present settings could not be saved first, and the journal cannot be written: %1 Apply once more to write without that copy and without the journal.</source>
        <translation>Nichts wird in den Controller geschrieben, weil die jetzigen Einstellungen vorher nicht gespeichert werden konnten und das Journal nicht geschrieben werden kann: %1 Nochmals Übernehmen drücken, um ohne diese Kopie und ohne das Journal zu schreiben.</translation>
    </message>
</context>
<context>
    <name>trex::PlayBar</name>
    <message>
        <source>Speed of play</source>
        <translation>Wiedergabegeschwindigkeit</translation>
    </message>
    <message>
        <source>Time at the playhead</source>
        <translation>Zeit an der Abspielmarke</translation>
    </message>
    <message>
        <source>Date and time at the playhead</source>
        <translation>Datum und Uhrzeit an der Abspielmarke</translation>
    </message>
    <message>
        <source>The whole recording and the playhead</source>
        <translation>Die ganze Aufzeichnung und die Abspielmarke</translation>
    </message>
    <message>
        <source>Previous &amp;event</source>
        <translation>Voriges &amp;Ereignis</translation>
    </message>
    <message>
        <source>Sample &amp;back</source>
        <translation>Einen Messwert &amp;zurück</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Wiedergabe</translation>
    </message>
    <message>
        <source>Sample &amp;forward</source>
        <translation>Einen Messwert &amp;vor</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>&amp;Nächstes Ereignis</translation>
    </message>
    <message>
        <source>How fast the recording is played</source>
        <translation>Wie schnell die Aufzeichnung wiedergegeben wird</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>loading, %1 %</source>
        <translation>wird geladen, %1 %</translation>
    </message>
    <message>
        <source>armed then</source>
        <translation>damals scharf</translation>
    </message>
    <message>
        <source>disarmed then</source>
        <translation>damals nicht scharf</translation>
    </message>
</context>
<context>
    <name>trex::PlotPane</name>
    <message>
        <source>Add curves, move or remove this plot</source>
        <translation>Kurven hinzufügen, dieses Diagramm verschieben oder entfernen</translation>
    </message>
    <message>
        <source>Plot %1 of %2</source>
        <translation>Diagramm %1 von %2</translation>
    </message>
    <message>
        <source>Plot %1: menu</source>
        <translation>Diagramm %1: Menü</translation>
    </message>
    <message>
        <source>No curves. Drag one in here, or add one from the menu.</source>
        <translation>Keine Kurven. Ziehen Sie eine hierher, oder fügen Sie eine aus dem Menü hinzu.</translation>
    </message>
</context>
<context>
    <name>trex::PlotStack</name>
    <message>
        <source>Shown</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>plain number</source>
        <translation>reine Zahl</translation>
    </message>
    <message>
        <source>Move to</source>
        <translation>Verschieben nach</translation>
    </message>
    <message>
        <source>A new plot</source>
        <translation>Ein neues Diagramm</translation>
    </message>
    <message>
        <source>Remove from this plot</source>
        <translation>Aus diesem Diagramm entfernen</translation>
    </message>
    <message>
        <source>Add a curve</source>
        <translation>Kurve hinzufügen</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Higher</source>
        <translation>Höher</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Niedriger</translation>
    </message>
    <message>
        <source>New plot</source>
        <translation>Neues Diagramm</translation>
    </message>
    <message>
        <source>Remove this plot</source>
        <translation>Dieses Diagramm entfernen</translation>
    </message>
</context>
<context>
    <name>trex::PlotsPanel</name>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Frozen view %1</source>
        <translation>Eingefrorene Ansicht %1</translation>
    </message>
    <message>
        <source>View before</source>
        <translation>Vorige Ansicht</translation>
    </message>
    <message>
        <source>Back to the view before (Alt+Left in a plot)</source>
        <translation>Zurück zur vorigen Ansicht (Alt+Links in einem Diagramm)</translation>
    </message>
    <message>
        <source>View after</source>
        <translation>Nächste Ansicht</translation>
    </message>
    <message>
        <source>Forward again (Alt+Right in a plot)</source>
        <translation>Wieder vor (Alt+Rechts in einem Diagramm)</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Closer in time (+ or the wheel; with Ctrl the values)</source>
        <translation>Näher in der Zeit (+ oder Mausrad; mit Strg die Werte)</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>More time (− or the wheel; with Ctrl the values)</source>
        <translation>Mehr Zeit (− oder Mausrad; mit Strg die Werte)</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Show everything recorded in this session (F)</source>
        <translation>Alles zeigen, was in dieser Sitzung aufgenommen wurde (F)</translation>
    </message>
    <message>
        <source>Drag to pan</source>
        <translation>Ziehen verschiebt</translation>
    </message>
    <message>
        <source>Dragging moves the picture instead of zooming into a box</source>
        <translation>Ziehen verschiebt das Bild, statt in einen Rahmen zu zoomen</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Gezeigte Zeit</translation>
    </message>
    <message>
        <source>How much time the plots show</source>
        <translation>Wie viel Zeit die Diagramme zeigen</translation>
    </message>
    <message>
        <source>Hold the picture still; recording goes on behind</source>
        <translation>Das Bild anhalten; die Aufzeichnung läuft weiter</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Two cursors to measure with (1 and 2 in a plot)</source>
        <translation>Zwei Cursor zum Messen (1 und 2 in einem Diagramm)</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Catch the moment a curve crosses a level</source>
        <translation>Den Moment festhalten, in dem eine Kurve einen Pegel überschreitet</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>Listen</translation>
    </message>
    <message>
        <source>Curves to add, events, runs to compare with</source>
        <translation>Kurven zum Hinzufügen, Ereignisse, Läufe zum Vergleichen</translation>
    </message>
    <message>
        <source>Add a plot, or put them as they were at first</source>
        <translation>Ein Diagramm hinzufügen, oder alle wie am Anfang</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Save samples as CSV, or the picture as PNG or SVG</source>
        <translation>Messwerte als CSV speichern, oder das Bild als PNG oder SVG</translation>
    </message>
    <message>
        <source>New plot</source>
        <translation>Neues Diagramm</translation>
    </message>
    <message>
        <source>As at first</source>
        <translation>Wie am Anfang</translation>
    </message>
    <message>
        <source>All samples or picture…</source>
        <translation>Alle Messwerte oder Bild …</translation>
    </message>
    <message>
        <source>Visible part…</source>
        <translation>Sichtbarer Teil …</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Copy visible samples</source>
        <translation>Sichtbare Messwerte kopieren</translation>
    </message>
    <message>
        <source>Click to add to the plot used last, or drag into a plot.</source>
        <translation>Klicken fügt dem zuletzt benutzten Diagramm hinzu; oder in ein Diagramm ziehen.</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Export the visible part</source>
        <translation>Sichtbaren Teil exportieren</translation>
    </message>
    <message>
        <source>Samples as CSV (*.csv);;Picture as PNG (*.png);;Picture as SVG (*.svg)</source>
        <translation>Messwerte als CSV (*.csv);;Bild als PNG (*.png);;Bild als SVG (*.svg)</translation>
    </message>
    <message>
        <source>Plots saved as %1.</source>
        <translation>Diagramme als %1 gespeichert.</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) of samples exported to %1.</source>
        <translation>
            <numerusform>%n Zeile Messwerte nach %1 exportiert.</numerusform>
            <numerusform>%n Zeilen Messwerte nach %1 exportiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>The picture of the plots was copied.</source>
        <translation>Das Bild der Diagramme wurde kopiert.</translation>
    </message>
    <message>
        <source>Too much for the clipboard: export the visible part to a file.</source>
        <translation>Zu viel für die Zwischenablage: Exportieren Sie den sichtbaren Teil in eine Datei.</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) of samples copied.</source>
        <translation>
            <numerusform>%n Zeile Messwerte kopiert.</numerusform>
            <numerusform>%n Zeilen Messwerte kopiert.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::PortBox</name>
    <message>
        <source>simulated controller</source>
        <translation>simulierter Controller</translation>
    </message>
    <message>
        <source>Simulated controller</source>
        <translation>Simulierter Controller</translation>
    </message>
</context>
<context>
    <name>trex::Program</name>
    <message>
        <source>The demonstration wrote to %1:</source>
        <translation>Die Vorführung schrieb nach %1:</translation>
    </message>
    <message>
        <source>The memory for the history of this session (%1 MiB) is full. From now on its oldest part is only in a recording, if one runs.</source>
        <translation>Der Speicher für den Verlauf dieser Sitzung (%1 MiB) ist voll. Von jetzt an steht der älteste Teil nur noch in einer Aufzeichnung, falls eine läuft.</translation>
    </message>
</context>
<context>
    <name>trex::RawSpinBox</name>
    <message>
        <source>%1: %2 is outside of what can be stored, %3; the value stays as it was.</source>
        <translation>%1: %2 liegt außerhalb des Speicherbaren, %3; der Wert bleibt, wie er war.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is no number that can be stored, %3; the value stays as it was.</source>
        <translation>%1: „%2“ ist keine speicherbare Zahl, %3; der Wert bleibt, wie er war.</translation>
    </message>
    <message>
        <source>%1 has its top bit clear. The top bit of the polynomial is always 1 and is not stored, so %1 is taken as what is stored: the polynomial in full is %2.</source>
        <translation>Bei %1 ist das oberste Bit gelöscht. Das oberste Bit des Polynoms ist immer 1 und wird nicht gespeichert, daher gilt %1 als das Gespeicherte: Das vollständige Polynom ist %2.</translation>
    </message>
</context>
<context>
    <name>trex::RecordingActions</name>
    <message>
        <source>Recordings (*.trexrec);;All files (*)</source>
        <translation>Aufzeichnungen (*.trexrec);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>Auf&amp;zeichnen</translation>
    </message>
    <message>
        <source>Record to a &amp;file…</source>
        <translation>In eine &amp;Datei aufzeichnen…</translation>
    </message>
    <message>
        <source>Record to a file</source>
        <translation>In eine Datei aufzeichnen</translation>
    </message>
    <message>
        <source>&amp;Keep the last minutes</source>
        <translation>Die letzten &amp;Minuten behalten</translation>
    </message>
    <message>
        <source>Writes what was seen in the last minutes to a file of its own, now.</source>
        <translation>Schreibt jetzt in eine eigene Datei, was in den letzten Minuten zu sehen war.</translation>
    </message>
    <message>
        <source>&amp;Open recording…</source>
        <translation>Aufzeichnung ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>&amp;Compare with recording…</source>
        <translation>Mit Aufzeichnung &amp;vergleichen…</translation>
    </message>
    <message>
        <source>Draws another recording behind the curves of the plots.</source>
        <translation>Zeichnet eine andere Aufzeichnung hinter die Kurven der Diagramme.</translation>
    </message>
    <message>
        <source>Compare with a recording</source>
        <translation>Mit einer Aufzeichnung vergleichen</translation>
    </message>
    <message>
        <source>Show the folder of &amp;recordings</source>
        <translation>O&amp;rdner der Aufzeichnungen zeigen</translation>
    </message>
    <message>
        <source>Record every &amp;packet, too</source>
        <translation>Auch jedes &amp;Paket aufzeichnen</translation>
    </message>
    <message>
        <source>Keep the last minutes at a fault, a stop or a lost &amp;link</source>
        <translation>Die letzten Minuten bei Störung, Stopp oder Verbindungsver&amp;lust behalten</translation>
    </message>
    <message>
        <source>The flight recorder: %1</source>
        <translation>Der Flugschreiber: %1</translation>
    </message>
    <message>
        <source>F&amp;older for recordings…</source>
        <translation>&amp;Ordner für Aufzeichnungen…</translation>
    </message>
    <message>
        <source>Folder for the last &amp;minutes…</source>
        <translation>Ordner für die letzten &amp;Minuten…</translation>
    </message>
    <message>
        <source>End &amp;recording</source>
        <translation>Aufzeichnung &amp;beenden</translation>
    </message>
    <message>
        <source>Ends the recording %1.</source>
        <translation>Beendet die Aufzeichnung %1.</translation>
    </message>
    <message>
        <source>Records everything from now on to a file in %1.</source>
        <translation>Zeichnet ab jetzt alles in eine Datei in %1 auf.</translation>
    </message>
    <message>
        <source>Le&amp;ngth of the last minutes</source>
        <translation>Lä&amp;nge der letzten Minuten</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s)</source>
        <translation>
            <numerusform>%n Minute</numerusform>
            <numerusform>%n Minuten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::RecordingFiles</name>
    <message>
        <source>Compared with %1: its curves lie behind those of the plots.</source>
        <translation>Verglichen mit %1: Die Kurven liegen hinter denen der Diagramme.</translation>
    </message>
</context>
<context>
    <name>trex::RecordingLamp</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>recording %1 · %2</source>
        <translation>Aufzeichnung %1 · %2</translation>
    </message>
    <message>
        <source>recording ended: the file could not be written</source>
        <translation>Aufzeichnung beendet: Die Datei ließ sich nicht schreiben</translation>
    </message>
</context>
<context>
    <name>trex::RecordingTimeline</name>
    <message>
        <source>Drag to move the playhead. Keys: Left, Right, Home, End.</source>
        <translation>Ziehen bewegt die Abspielmarke. Tasten: Links, Rechts, Pos1, Ende.</translation>
    </message>
</context>
<context>
    <name>trex::RecordingWindow</name>
    <message>
        <source>Recording of %1 – %2</source>
        <translation>Aufzeichnung vom %1 – %2</translation>
    </message>
    <message>
        <source>an unknown date</source>
        <translation>unbekannten Datum</translation>
    </message>
    <message>
        <source>Recording of %1</source>
        <translation>Aufzeichnung vom %1</translation>
    </message>
    <message>
        <source>This window shows a recording</source>
        <translation>Dieses Fenster zeigt eine Aufzeichnung</translation>
    </message>
    <message>
        <source>not live: nothing here reaches a controller</source>
        <translation>nicht live: Nichts von hier erreicht einen Controller</translation>
    </message>
    <message>
        <source>Stop all motors</source>
        <translation>Alle Motoren anhalten</translation>
    </message>
    <message>
        <source>Stops the motors of the controller that is connected now.</source>
        <translation>Hält die Motoren des Controllers an, der jetzt verbunden ist.</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open recording…</source>
        <translation>Aufzeichnung ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>&amp;Compare with recording…</source>
        <translation>Mit Aufzeichnung &amp;vergleichen…</translation>
    </message>
    <message>
        <source>Compare with a recording</source>
        <translation>Mit einer Aufzeichnung vergleichen</translation>
    </message>
    <message>
        <source>&amp;Export all samples…</source>
        <translation>Alle Messwerte &amp;exportieren…</translation>
    </message>
    <message>
        <source>Export all samples</source>
        <translation>Alle Messwerte exportieren</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Wiedergabe</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Put all panels back</source>
        <translation>Alle Bereiche zurücksetzen</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) exported to %1.</source>
        <translation>
            <numerusform>%n Zeile nach %1 exportiert.</numerusform>
            <numerusform>%n Zeilen nach %1 exportiert.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::Recordings</name>
    <message>
        <source>there was a fault</source>
        <translation>es gab eine Störung</translation>
    </message>
    <message>
        <source>the motors were stopped while armed</source>
        <translation>die Motoren wurden angehalten, während sie scharf waren</translation>
    </message>
    <message>
        <source>the link was lost</source>
        <translation>die Verbindung ging verloren</translation>
    </message>
    <message>
        <source>Recording to %1.</source>
        <translation>Aufzeichnung nach %1.</translation>
    </message>
    <message numerus="yes">
        <source>Recording ended: %n sample(s) in %1.</source>
        <translation>
            <numerusform>Aufzeichnung beendet: %n Messwert in %1.</numerusform>
            <numerusform>Aufzeichnung beendet: %n Messwerte in %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording has ended: %1 The file keeps what was written before.</source>
        <translation>Die Aufzeichnung ist beendet: %1 Die Datei behält, was vorher geschrieben wurde.</translation>
    </message>
    <message>
        <source>The last minutes could not be kept: %1</source>
        <translation>Die letzten Minuten konnten nicht behalten werden: %1</translation>
    </message>
    <message>
        <source>The last minutes are kept in %1.</source>
        <translation>Die letzten Minuten liegen in %1.</translation>
    </message>
    <message>
        <source>The last minutes are kept in %1: %2.</source>
        <translation>Die letzten Minuten liegen in %1: %2.</translation>
    </message>
</context>
<context>
    <name>trex::ResponseCurveView</name>
    <message>
        <source>The calibration has not been read yet.</source>
        <translation>Die Kalibrierung ist noch nicht gelesen.</translation>
    </message>
    <message>
        <source>No fresh reading.</source>
        <translation>Kein neuer Messwert.</translation>
    </message>
    <message>
        <source>%1: %2 before, %3 new</source>
        <translation>%1: %2 zuvor, %3 neu</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Response of channel %1</source>
        <translation>Kennlinie von Kanal %1</translation>
    </message>
    <message>
        <source>What channel %1 makes of its input. ≈: the exact form of the parabola is not published; this one is a guess.</source>
        <translation>Was Kanal %1 aus seinem Eingang macht. ≈: Die genaue Form der Parabel ist nicht veröffentlicht; diese ist vermutet.</translation>
    </message>
    <message>
        <source>What channel %1 makes of its input.</source>
        <translation>Was Kanal %1 aus seinem Eingang macht.</translation>
    </message>
    <message>
        <source>before</source>
        <translation>zuvor</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>≈ parabolic</source>
        <translation>≈ parabolisch</translation>
    </message>
</context>
<context>
    <name>trex::RestartLine</name>
    <message>
        <source>Restart of the controller</source>
        <translation>Neustart des Controllers</translation>
    </message>
    <message>
        <source>Dis&amp;miss</source>
        <translation>&amp;Ausblenden</translation>
    </message>
    <message>
        <source>Takes this line away</source>
        <translation>Nimmt diese Zeile weg</translation>
    </message>
    <message>
        <source>The controller was restarted at %1.</source>
        <translation>Der Controller wurde um %1 neu gestartet.</translation>
    </message>
    <message>
        <source>The controller was silent and answers again since %1: it may have been restarted.</source>
        <translation>Der Controller schwieg und antwortet seit %1 wieder: Er wurde vielleicht neu gestartet.</translation>
    </message>
    <message>
        <source>Everything is being read again.</source>
        <translation>Alles wird neu gelesen.</translation>
    </message>
    <message>
        <source>Everything was read again.</source>
        <translation>Alles wurde neu gelesen.</translation>
    </message>
    <message>
        <source>Not everything could be read again: press Reload.</source>
        <translation>Nicht alles ließ sich neu lesen: Drücken Sie „Neu lesen“.</translation>
    </message>
    <message>
        <source>In force since then: %1.</source>
        <translation>Seitdem in Kraft: %1.</translation>
    </message>
    <message>
        <source>If it was, in force since then: %1.</source>
        <translation>Wenn ja, gilt seitdem: %1.</translation>
    </message>
</context>
<context>
    <name>trex::RestartWatch</name>
    <message>
        <source>a reply was missing, and motor %1 draws no current any more although its order stands</source>
        <translation>eine Antwort fehlte, und Motor %1 zieht keinen Strom mehr, obwohl sein Befehl gilt</translation>
    </message>
</context>
<context>
    <name>trex::SafetyDialog</name>
    <message>
        <source>Safety and limits</source>
        <translation>Sicherheit und Grenzen</translation>
    </message>
    <message>
        <source>Safety and limits of the motors</source>
        <translation>Sicherheit und Grenzen der Motoren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Stop and disarm by itself</source>
        <translation>Von selbst anhalten und sichern</translation>
    </message>
    <message>
        <source>Always: a lost link, a restarted controller, disconnecting, quitting, a crash or standstill of this program. Also:</source>
        <translation>Immer: verlorene Verbindung, Neustart des Controllers, Trennen, Beenden, Absturz oder Stillstand dieses Programms. Außerdem:</translation>
    </message>
    <message>
        <source>A motor driver&apos;s fault</source>
        <translation>Fehler eines Motortreibers</translation>
    </message>
    <message>
        <source>Status bits 4 and 6: short circuit, heat, too low a supply.</source>
        <translation>Statusbits 4 und 6: Kurzschluss, Hitze, zu niedrige Versorgung.</translation>
    </message>
    <message>
        <source>Over-current</source>
        <translation>Überstrom</translation>
    </message>
    <message>
        <source>Status bits 5 and 7. A current limit that does its work lights them, too.</source>
        <translation>Statusbits 5 und 7. Auch eine Strombegrenzung, die arbeitet, setzt sie.</translation>
    </message>
    <message>
        <source>An error on the line</source>
        <translation>Ein Fehler auf der Leitung</translation>
    </message>
    <message>
        <source>Any bit of the UART error byte but the timeout.</source>
        <translation>Jedes Bit des UART-Fehlerbytes außer der Zeitüberschreitung.</translation>
    </message>
    <message>
        <source>The controller&apos;s serial timeout</source>
        <translation>Die serielle Zeitüberwachung des Controllers</translation>
    </message>
    <message>
        <source>It has stopped the motors by itself; the next order would start them again.</source>
        <translation>Sie hat die Motoren selbst angehalten; der nächste Befehl würde sie wieder starten.</translation>
    </message>
    <message>
        <source>Screen locked, computer to sleep</source>
        <translation>Bildschirm gesperrt, Rechner im Ruhezustand</translation>
    </message>
    <message>
        <source>As the desktop tells it, where it does.</source>
        <translation>Wie es der Desktop meldet, wo er es tut.</translation>
    </message>
    <message>
        <source>All windows hidden or minimised</source>
        <translation>Alle Fenster verborgen oder minimiert</translation>
    </message>
    <message>
        <source>STOP would be out of reach.</source>
        <translation>STOPP wäre außer Reichweite.</translation>
    </message>
    <message>
        <source>Idle time</source>
        <translation>Leerlaufzeit</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>All motors at zero, and no order given for so long. A motor that runs is not idle.</source>
        <translation>Alle Motoren auf null und so lange kein Befehl. Ein laufender Motor ist nicht im Leerlauf.</translation>
    </message>
    <message>
        <source>No order for</source>
        <translation>Kein Befehl seit</translation>
    </message>
    <message>
        <source>Limits and ramps</source>
        <translation>Grenzen und Rampen</translation>
    </message>
    <message>
        <source> of 127</source>
        <translation> von 127</translation>
    </message>
    <message>
        <source>Motor 1 at most</source>
        <translation>Motor 1 höchstens</translation>
    </message>
    <message>
        <source>Motor 2 at most</source>
        <translation>Motor 2 höchstens</translation>
    </message>
    <message>
        <source>Auxiliary at most</source>
        <translation>Hilfsmotor höchstens</translation>
    </message>
    <message>
        <source>Slider step at most</source>
        <translation>Schieberschritt höchstens</translation>
    </message>
    <message>
        <source> a second</source>
        <translation> je Sekunde</translation>
    </message>
    <message>
        <source>Soft start</source>
        <translation>Sanfter Anlauf</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>sofort</translation>
    </message>
    <message>
        <source>Soft stop</source>
        <translation>Sanfter Auslauf</translation>
    </message>
    <message>
        <source>Speed steps a second, for orders that are set at once. Accelerate is the controller&apos;s own. STOP never ramps.</source>
        <translation>Geschwindigkeitsstufen je Sekunde, für sofort gesetzte Befehle. Beschleunigen ist Sache des Controllers. STOPP hat nie eine Rampe.</translation>
    </message>
    <message>
        <source>Stall guard, current</source>
        <translation>Blockierschutz, Strom</translation>
    </message>
    <message>
        <source> A</source>
        <translation> A</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>As much for as long: all motors are led to zero, then disarmed. In joint mode the controller reports no current, and nothing is guarded.</source>
        <translation>So viel für so lange: Alle Motoren werden auf null geführt, dann gesichert. Im gemeinsamen Betrieb meldet der Controller keinen Strom, und nichts ist geschützt.</translation>
    </message>
    <message>
        <source>Stall guard from</source>
        <translation>Blockierschutz ab</translation>
    </message>
    <message>
        <source>for</source>
        <translation>für</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Hold to run</source>
        <translation>Nur gehalten fahren</translation>
    </message>
    <message>
        <source>Speed of keys and buttons</source>
        <translation>Geschwindigkeit von Tasten und Knöpfen</translation>
    </message>
</context>
<context>
    <name>trex::Scan</name>
    <message>
        <source>Trying %1 baud, error detection %2</source>
        <extracomment>%1 a baud rate; %2 none, even, odd or crc7</extracomment>
        <translation>Versuch mit %1 Baud, Fehlererkennung %2</translation>
    </message>
    <message>
        <source>%1, device %2</source>
        <translation>%1, Gerät %2</translation>
    </message>
</context>
<context>
    <name>trex::SerialTimeoutWatch</name>
    <message>
        <source>The controller&apos;s serial timeout could not be read (%1). Whether the motors would stop if this program died is not known.</source>
        <translation>Die serielle Zeitüberwachung des Controllers ließ sich nicht lesen (%1). Ob die Motoren anhielten, wenn dieses Programm ausfiele, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The controller&apos;s serial timeout is off: if this program, its computer or the cable fails, the motors run on.</source>
        <translation>Die serielle Zeitüberwachung des Controllers ist aus: Fallen dieses Programm, sein Rechner oder das Kabel aus, laufen die Motoren weiter.</translation>
    </message>
    <message>
        <source>The controller&apos;s serial timeout is %1 ms now: the motors stop when nothing is heard from here for so long.</source>
        <translation>Die serielle Zeitüberwachung des Controllers ist jetzt %1 ms: Die Motoren halten an, wenn von hier so lange nichts zu hören ist.</translation>
    </message>
    <message>
        <source>The serial timeout was not set: %1</source>
        <translation>Die serielle Zeitüberwachung wurde nicht gesetzt: %1</translation>
    </message>
</context>
<context>
    <name>trex::SessionRecorder</name>
    <message numerus="yes">
        <source>The disk was too slow: %n events or packets were left out so far.</source>
        <translation>
            <numerusform>Der Datenträger war zu langsam: %n Ereignis oder Paket wurde bisher ausgelassen.</numerusform>
            <numerusform>Der Datenträger war zu langsam: %n Ereignisse oder Pakete wurden bisher ausgelassen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::SessionWatch</name>
    <message>
        <source>The motors are stopped before the computer sleeps.</source>
        <translation>Die Motoren werden angehalten, bevor der Rechner schläft.</translation>
    </message>
</context>
<context>
    <name>trex::StatusPanel</name>
    <message>
        <source>Motor 1 fault</source>
        <translation>Störung Motor 1</translation>
    </message>
    <message>
        <source>Motor 1 over limit</source>
        <translation>Überstrom Motor 1</translation>
    </message>
    <message>
        <source>Motor 2 fault</source>
        <translation>Störung Motor 2</translation>
    </message>
    <message>
        <source>Motor 2 over limit</source>
        <translation>Überstrom Motor 2</translation>
    </message>
    <message>
        <source>UART error</source>
        <translation>UART-Fehler</translation>
    </message>
    <message>
        <source>Serial timeout</source>
        <translation>Zeitüberschreitung</translation>
    </message>
    <message>
        <source>Packet format</source>
        <translation>Paketformat</translation>
    </message>
    <message>
        <source>CRC</source>
        <translation>CRC</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Data overrun</source>
        <translation>Datenüberlauf</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>Parität</translation>
    </message>
    <message>
        <source>Read buffer overrun</source>
        <translation>Lesepufferüberlauf</translation>
    </message>
    <message>
        <source>Send buffer overrun</source>
        <translation>Sendepufferüberlauf</translation>
    </message>
    <message>
        <source>RC</source>
        <translation>RC</translation>
    </message>
    <message>
        <source>Analog</source>
        <translation>Analog</translation>
    </message>
    <message>
        <source>Serial (RC)</source>
        <translation>Seriell (RC)</translation>
    </message>
    <message>
        <source>Serial (analog)</source>
        <translation>Seriell (analog)</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Signatur</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Motors follow</source>
        <translation>Motoren folgen</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>Kalibriert</translation>
    </message>
    <message>
        <source>Status byte</source>
        <translation>Statusbyte</translation>
    </message>
    <message>
        <source>UART error byte</source>
        <translation>UART-Fehlerbyte</translation>
    </message>
    <message>
        <source>Clear counts</source>
        <translation>Zähler löschen</translation>
    </message>
    <message>
        <source>Clear the counts of seen bits</source>
        <translation>Zähler der gesehenen Bits löschen</translation>
    </message>
    <message>
        <source>Forgets how often each bit was seen. The controller&apos;s own bits are cleared by every read.</source>
        <translation>Vergisst, wie oft jedes Bit gesehen wurde. Die Bits im Controller selbst löscht jedes Lesen.</translation>
    </message>
    <message>
        <source>serial orders (serial mode)</source>
        <translation>seriellen Befehlen (serieller Modus)</translation>
    </message>
    <message>
        <source>serial orders (override by channel 5)</source>
        <translation>seriellen Befehlen (Übernahme durch Kanal 5)</translation>
    </message>
    <message>
        <source>the RC channels (mode jumper)</source>
        <translation>den RC-Kanälen (Modus-Steckbrücke)</translation>
    </message>
    <message>
        <source>the analog channels (mode jumper)</source>
        <translation>den Analogkanälen (Modus-Steckbrücke)</translation>
    </message>
    <message>
        <source>no channel (defaults)</source>
        <translation>kein Kanal (Standard)</translation>
    </message>
    <message>
        <source>channels %1</source>
        <translation>Kanäle %1</translation>
    </message>
    <message>
        <source>Not seen.</source>
        <translation>Nicht gesehen.</translation>
    </message>
    <message numerus="yes">
        <source>Seen %n time(s), first %1, last %2.</source>
        <translation>
            <numerusform>%n-mal gesehen, zuerst %1, zuletzt %2.</numerusform>
            <numerusform>%n-mal gesehen, zuerst %1, zuletzt %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>trex::StopButton</name>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop all motors</source>
        <translation>Alle Motoren anhalten</translation>
    </message>
    <message>
        <source>Stops all three motors at once (Esc, from anywhere).</source>
        <translation>Hält sofort alle drei Motoren an (Esc, von überall).</translation>
    </message>
</context>
<context>
    <name>trex::TimeWindowBox</name>
    <message>
        <source>10 s</source>
        <translation>10 s</translation>
    </message>
    <message>
        <source>30 s</source>
        <translation>30 s</translation>
    </message>
    <message>
        <source>1 min</source>
        <translation>1 min</translation>
    </message>
    <message>
        <source>5 min</source>
        <translation>5 min</translation>
    </message>
    <message>
        <source>30 min</source>
        <translation>30 min</translation>
    </message>
    <message>
        <source>1 h</source>
        <translation>1 h</translation>
    </message>
    <message>
        <source>whole session</source>
        <translation>gesamte Sitzung</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>trex::TimeoutBanner</name>
    <message>
        <source>Serial timeout</source>
        <translation>Zeitüberschreitung</translation>
    </message>
    <message>
        <source>Serial timeout off: if this program or its line fails, the motors run on.</source>
        <translation>Serielle Zeitüberwachung aus: Fällt dieses Programm oder seine Leitung aus, laufen die Motoren weiter.</translation>
    </message>
    <message>
        <source>Set %1 ms</source>
        <translation>%1 ms setzen</translation>
    </message>
    <message>
        <source>Set the serial timeout to %1 ms</source>
        <translation>Serielle Zeitüberwachung auf %1 ms setzen</translation>
    </message>
    <message>
        <source>Writes the parameter and reads it back. The motors then stop when the controller has heard nothing for so long; while it is armed, this program sees to it that it always hears something.</source>
        <translation>Schreibt den Parameter und liest ihn zurück. Die Motoren halten dann an, wenn der Controller so lange nichts gehört hat; solange scharf geschaltet ist, sorgt dieses Programm dafür, dass er immer etwas hört.</translation>
    </message>
    <message>
        <source>Settings can be written in serial mode only (mode jumper off).</source>
        <translation>Einstellungen lassen sich nur im seriellen Betrieb schreiben (ohne Betriebsart-Brücke).</translation>
    </message>
</context>
<context>
    <name>trex::TriggerBar</name>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Trigger source</source>
        <translation>Triggerquelle</translation>
    </message>
    <message>
        <source>Trigger edge</source>
        <translation>Triggerflanke</translation>
    </message>
    <message>
        <source>Trigger level</source>
        <translation>Triggerpegel</translation>
    </message>
    <message>
        <source>Trigger mode</source>
        <translation>Triggerart</translation>
    </message>
    <message>
        <source>Shown before the trigger</source>
        <translation>Vor dem Trigger gezeigt</translation>
    </message>
    <message>
        <source>Wait again</source>
        <translation>Neu warten</translation>
    </message>
    <message>
        <source>Trigger state</source>
        <translation>Zustand des Triggers</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>steigend</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>fallend</translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>beide Richtungen</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Einmal</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Single: the first crossing is held. Normal: each crossing replaces the one before. Auto: as Normal, but the picture moves on while none comes.</source>
        <translation>Einmal: Das erste Überschreiten wird festgehalten. Normal: Jedes Überschreiten ersetzt das vorige. Automatisch: wie Normal, aber das Bild läuft weiter, solange keines kommt.</translation>
    </message>
    <message>
        <source>The level; its line in the plot can be dragged</source>
        <translation>Der Pegel; seine Linie im Diagramm lässt sich ziehen</translation>
    </message>
    <message>
        <source>How much of the window lies before the crossing</source>
        <translation>Wie viel des Fensters vor dem Überschreiten liegt</translation>
    </message>
    <message>
        <source>Forget what was caught and wait for the next crossing</source>
        <translation>Das Festgehaltene vergessen und auf das nächste Überschreiten warten</translation>
    </message>
    <message>
        <source>Waiting, running freely</source>
        <translation>Wartet, läuft frei</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>Ausgelöst</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Festgehalten</translation>
    </message>
</context>
<context>
    <name>trex::WatchdogDialog</name>
    <message>
        <source>Watchdog proof</source>
        <translation>Nachweis der Zeitüberwachung</translation>
    </message>
    <message>
        <source>Does the controller stop when it hears nothing?</source>
        <translation>Hält der Controller an, wenn er nichts hört?</translation>
    </message>
    <message>
        <source>What will happen</source>
        <translation>Was geschehen wird</translation>
    </message>
    <message>
        <source>Motor for the proof</source>
        <translation>Motor für den Nachweis</translation>
    </message>
    <message>
        <source>Motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>Motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>Speed for the proof</source>
        <translation>Geschwindigkeit für den Nachweis</translation>
    </message>
    <message>
        <source> of 127</source>
        <translation> von 127</translation>
    </message>
    <message>
        <source>Result of the proof</source>
        <translation>Ergebnis des Nachweises</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Turn the motor and prove</source>
        <translation>Motor drehen und nachweisen</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>The motor turns slowly; then this program sends nothing on purpose, and looks afterwards whether the motor has stopped and the timeout is latched. Esc stops at any time, and the proof ends in a stop.</source>
        <translation>Der Motor dreht langsam; dann sendet dieses Programm absichtlich nichts und sieht danach nach, ob der Motor steht und die Zeitüberschreitung vermerkt ist. Esc hält jederzeit an, und der Nachweis endet mit einem Stopp.</translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation>Nicht verbunden.</translation>
    </message>
    <message>
        <source>The serial timeout is off or not known: set it first.</source>
        <translation>Die serielle Zeitüberwachung ist aus oder nicht bekannt: Setzen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>Serial timeout: %1 ms. It takes %2 s at most.</source>
        <translation>Serielle Zeitüberwachung: %1 ms. Es dauert höchstens %2 s.</translation>
    </message>
    <message>
        <source>Arm the motors to start it.</source>
        <translation>Zum Starten die Motoren scharf schalten.</translation>
    </message>
    <message>
        <source>Ended before it was done; all motors were told to stop.</source>
        <translation>Vorzeitig beendet; alle Motoren haben den Stopp bekommen.</translation>
    </message>
</context>
<context>
    <name>trex::WatchdogProof</name>
    <message>
        <source>the serial timeout is off</source>
        <translation>die serielle Zeitüberwachung ist aus</translation>
    </message>
    <message>
        <source>The motor turns; then nothing is sent for %1 ms.</source>
        <translation>Der Motor dreht; dann wird %1 ms lang nichts gesendet.</translation>
    </message>
    <message>
        <source>the motor still ran after %1 ms of silence</source>
        <translation>der Motor lief nach %1 ms Stille noch</translation>
    </message>
    <message>
        <source>the motor had stopped after %1 ms already</source>
        <translation>der Motor stand schon nach %1 ms</translation>
    </message>
    <message>
        <source>the motor stopped, but no timeout was latched</source>
        <translation>der Motor hielt an, aber keine Zeitüberschreitung wurde vermerkt</translation>
    </message>
    <message>
        <source>it stopped between %1 and %2 ms of silence</source>
        <translation>er hielt zwischen %1 und %2 ms Stille an</translation>
    </message>
    <message>
        <source>it did not stop in %1 silences</source>
        <translation>er hielt in %1 Pausen nicht an</translation>
    </message>
    <message>
        <source>Watchdog proof passed: serial timeout %1 ms, %2.</source>
        <translation>Nachweis bestanden: serielle Zeitüberwachung %1 ms, %2.</translation>
    </message>
    <message>
        <source>Watchdog proof FAILED: serial timeout %1 ms, %2. The motors may run on when this program or its line fails.</source>
        <translation>Nachweis NICHT bestanden: serielle Zeitüberwachung %1 ms, %2. Die Motoren laufen womöglich weiter, wenn dieses Programm oder seine Leitung ausfällt.</translation>
    </message>
    <message>
        <source>The current was too small to see it collapse: only the timeout bit was judged.</source>
        <translation>Der Strom war zu klein, um sein Ende zu sehen: Beurteilt wurde nur das Bit der Zeitüberschreitung.</translation>
    </message>
</context>
<context>
    <name>trex::WhyLine</name>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Why the motors do or do not move</source>
        <translation>Warum die Motoren laufen oder nicht</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
</context>
<context>
    <name>trex::WriteAudit</name>
    <message>
        <source>The settings as they were could not be saved first: %1</source>
        <translation>Die bisherigen Einstellungen konnten vorher nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>Nothing is written to the controller, because the settings as they are could not be saved first: %1 Do it once more to write without that copy and its journal.</source>
        <translation>Nichts wird in den Controller geschrieben, weil die jetzigen Einstellungen vorher nicht gespeichert werden konnten: %1 Nochmals ausführen, um ohne diese Kopie und ihr Journal zu schreiben.</translation>
    </message>
    <message>
        <source>The result of a write is not recorded: %1</source>
        <translation>Das Ergebnis eines Schreibvorgangs ist nicht aufgezeichnet: %1</translation>
    </message>
    <message>
        <source>%1, write of %2 that was interrupted</source>
        <translation>%1, unterbrochener Schreibvorgang vom %2</translation>
    </message>
    <message>
        <source>%1: the controller holds the new value, %2.</source>
        <translation>%1: Der Controller enthält den neuen Wert, %2.</translation>
    </message>
    <message>
        <source>%1: the controller holds the old value, %2.</source>
        <translation>%1: Der Controller enthält den alten Wert, %2.</translation>
    </message>
    <message>
        <source>%1: the controller holds another value, %2.</source>
        <translation>%1: Der Controller enthält einen anderen Wert, %2.</translation>
    </message>
    <message>
        <source>%1: whether it took place cannot be read back; look at the parameters after the next power cycle.</source>
        <translation>%1: Ob es geschah, lässt sich nicht zurücklesen; nach dem nächsten Aus- und Einschalten die Parameter ansehen.</translation>
    </message>
</context>
</TS>
