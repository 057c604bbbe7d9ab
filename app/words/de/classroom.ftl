class-title = softrod: eine Klasse
class-needs-javascript = Für eine Klasse ist JavaScript nötig; hier ist es ausgeschaltet.
class-blocked = Die Seite ist geladen, aber ihre Verbindung kommt nicht zustande: Etwas auf dem Weg sperrt WebSockets. Versuche ein anderes Netz, etwa den Hotspot des Rechners der Lehrkraft.
class-over = Die Stunde ist zu Ende.
class-why = Warum? Antworte in einem Satz.
class-hand-in = Gib ab, was du gefunden hast.
class-goal = Ziel: { $goal }
class-goal-met = Erreicht: { $goal }
class-found = Was die Klasse gefunden hat
class-qr-code = QR-Code von { $address }
class-plot = { $what } über { $over }: { $count ->
    [one] 1 Punkt
   *[other] { $count } Punkte
  }
  .law = { $what } über { $over }: { $count ->
    [one] 1 Punkt
   *[other] { $count } Punkte
  }; { $law }
class-plot-you = du: { $value }
class-grip = Masse { $mass } deiner Vorhersage: mit den Pfeiltasten bewegen
class-moved =
  .lower = { $length } tiefer
  .higher = { $length } höher
  .left = { $length } nach links
  .right = { $length } nach rechts
class-where-put = eure Vorhersagen

## Die Seite einer Schülerin oder eines Schülers.

seat-region = Klasse
seat-nothing-kept = Nichts, was du abgegeben hast, bleibt hier gespeichert.
seat-away-alone = Nicht verbunden: Dein Körper bewegt sich hier weiter, aber das zählt nicht. Verbindung wird wieder aufgebaut …
seat-hand-up = Melden
seat-hand-is-up = Gemeldet
seat-on-page = Eine andere Seite dieses Browsers hat jetzt deinen Platz.
seat-on-device = Ein anderes Gerät hat jetzt deinen Platz.
seat-come-back = Hierher zurückholen
seat-who = Wer bist du? Gib deinen Namen ein, damit deine Lehrkraft weiß, wessen Antworten das sind.
seat-your-name = Dein Name
seat-name-me = Das bin ich
seat-on-wall = Deins ist jetzt auf der Leinwand.
seat-follow = Zum Körper der Lehrkraft
seat-own-body = Zurück zu meinem Körper
seat-about = Dieser Platz
seat-why = Die Frage und die Begründung
seat-waiting = Noch nicht bei der Lehrkraft: Es bleibt hier und wird gesendet, sobald das geht.
seat-letters = Die vier Buchstaben auf der Leinwand
seat-come-in = Eintreten

seat-is-in = Du bist dabei. Gleich geht es los.
seat-look = Schau nach vorn.
seat-teacher-away = Die Seite deiner Lehrkraft ist gerade weg: Warte einen Moment.
seat-gathered = Schau nach vorn: Das ist der Körper deiner Lehrkraft. Deiner wartet.
seat-follows = Das ist der Körper deiner Lehrkraft. Deiner wartet.
seat-paused = Angehalten: Schau nach vorn.
seat-can-change = Du kannst es noch ändern. Noch sieht es sonst niemand.
seat-ask-drag = Zieh den blassen Körper dorthin, wo er { $seconds } s nach dem Start sein wird. Noch sieht es sonst niemand.
seat-ask-both = Zieh den blassen Körper dorthin, wo er { $seconds } s nach dem Start sein wird, und wähle eine Antwort. Noch sieht es sonst niemand.
seat-ask-choose = Wähle eine Antwort. Noch sieht es sonst niemand.
seat-ask-again = Wähle noch einmal. Noch sieht es sonst niemand.
seat-try = Probier es aus: Dieser Körper gehört dir.

seat-home-drag = Zieh den blassen Körper dorthin, wo er { $seconds } s nach dem Start sein wird. Dann läuft es.
seat-home-both = Zieh den blassen Körper dorthin, wo er { $seconds } s nach dem Start sein wird, und wähle eine Antwort. Dann läuft es.
seat-home-choose = Wähle eine Antwort. Dann läuft es.
seat-late-now = Was du jetzt abgibst, gilt als verspätet.
seat-home-own = Jetzt bist du dran: Dieser Körper gehört dir.
seat-step = Schritt { $number }
seat-step-done = Schritt { $number }, erledigt
seat-next-step = Weiter: Schritt { $number } von { $steps }
seat-to-do = { $count ->
    [one] Noch zu tun: Schritt { $steps }.
   *[other] Noch zu tun: Schritte { $steps }.
  }
seat-all-done = Alle Schritte sind erledigt. Du kannst diese Seite schließen.
seat-told-on = Die richtige Antwort siehst du am { $date }.

seat-watch = Beobachte:
seat-chose-before = Zuvor hast du gewählt: { $choice }
seat-chose = { $late ->
    [yes] Du hast gewählt: { $choice } (verspätet: nachdem die Antworten gezeigt waren).
   *[no] Du hast gewählt: { $choice }.
  }
seat-right = Die richtige Antwort: { $choice }.

seat-predict = Dort wird er sein
  .place = Abgeben: { $place }
seat-predicted = Deine Vorhersage ist abgegeben
  .place = Deine Vorhersage ist abgegeben: { $place }
seat-step-left = Ein wenig nach links
seat-step-right = Ein wenig nach rechts
seat-step-up = Ein wenig nach oben
seat-step-down = Ein wenig nach unten

seat-because = Weil
seat-send = Senden
seat-change = Ändern
seat-sent = Gesendet ✓
seat-pause = Pause
seat-play = Start
seat-reset = Zurücksetzen
seat-slow = Mit einem Viertel der Geschwindigkeit
seat-reading = { $what }: { $reading }
seat-no-reading = Noch nichts abzulesen: Lass ihn sich eine Weile bewegen.
seat-hand-in = { $reading } abgeben
  .instead = Stattdessen { $reading } abgeben
seat-hand-in-it = Abgeben
  .instead = Stattdessen das abgeben
seat-hand-in-run = Diesen Lauf abgeben
  .instead = Stattdessen diesen Lauf abgeben
seat-handed = { $late ->
    [yes] Abgegeben (verspätet: nachdem die Antworten gezeigt waren).
   *[no] Abgegeben.
  }
  .text = { $late ->
    [yes] Abgegeben: { $text } (verspätet: nachdem die Antworten gezeigt waren).
   *[no] Abgegeben: { $text }.
  }

seat-first = Nummer eins von euch
seat-second = Nummer zwei von euch
seat-another-name = Anderer Name
seat-two = Wir sind zu zweit
seat-move = Auf einem anderen Gerät weitermachen
seat-move-digits = Am anderen Gerät { $digits } eingeben
seat-had = Ich hatte einen Platz auf einem anderen Gerät: seine zwei Ziffern
seat-take-over = Übernehmen

## Was die Lehrkraft in jeder Phase der Klasse sagt und (.do) tut.

guide-lobby = Öffnet die Adresse auf der Leinwand und gebt die vier Buchstaben ein.
  .do = Bringen Sie die Leinwandseite auf den Projektor. Weiter geht es, wenn alle da sind.
guide-show = Seht euch den Körper an: Was hält ihn, und was zieht an ihm?
  .before = Zeigen Sie auf die Teile. Drücken Sie noch nicht auf Start: Erst kommt die Frage, dann läuft es.
  .do = Zeigen Sie auf die Teile. Lassen Sie ihn mit Start los: Wonach die Frage fragt, kommt erst später.
guide-drag = Zieht den blassen Körper dorthin, wo er { $seconds } s nach dem Start sein wird.
guide-ask = Warten Sie, bis alle geantwortet haben. Sagen Sie nicht, was richtig ist.
guide-again = Überzeugt eine Minute lang eure Nachbarn. Dann antwortet noch einmal.
  .do = Hören Sie zu. Sagen Sie nicht, was richtig ist.
guide-results = Wer möchte sagen, warum ihr das gewählt habt?
  .do = Hören Sie zwei an, die verschieden geantwortet haben. Nennen Sie die richtige Antwort noch nicht.
guide-changed = Wer hat die Meinung geändert, und warum?
  .do = Nennen Sie die richtige Antwort noch nicht: Der Lauf wird sie zeigen.
guide-run = Beobachtet, was geschieht.
  .do = Lassen Sie es laufen, bis alle gesehen haben, was geschieht.
guide-run-new = Beobachtet, was geschieht. Das ist neu: { $runs }
guide-run-stops = Es hält bei { $seconds } s an. Vergleichen Sie es mit den Vorhersagen.
guide-reveal = Das ist die Antwort. Erklärt euren Nachbarn, warum.
  .predicted = Die Leinwand zeigt die Vorhersagen neben dem Körper, dann die richtige Antwort. Lassen Sie ihr einen Moment, bevor Sie sprechen.
  .do = Die Leinwand zeigt die richtige Antwort. Lassen Sie ihr einen Moment, bevor Sie sprechen.
guide-explain = Versehen Sie zwei Antworten mit einem Stern: Sie kommen in der nächsten Phase auf die Leinwand. Erklären Sie es dann mit eigenen Worten: { $because }
guide-try = Gehen Sie herum. Wer sich meldet, ist rechts zu sehen.
guide-collect = Gebt ab: { $collects }.
guide-plot = Wenn die meisten abgegeben haben, sehen Sie sich gemeinsam das Diagramm der Klasse an: Was sagt es? Drücken Sie auf „Gesetz zeigen“, falls es das gibt.
guide-collected = Wenn die meisten abgegeben haben, bringen Sie eines davon auf die Leinwand.

## Was der Server einer Seite der Klasse sagt.

class-refuse-together = Die Klasse geht gemeinsam weiter.
class-refuse-no-home-step = Diesen Schritt hat die Hausaufgabe nicht.
class-refuse-no-place = Diese Stelle hat die Stunde nicht.
class-refuse-sealed = Niemand sieht die Antworten, bevor alle gezeigt werden.
class-refuse-no-bodies = Die Plätze haben gerade keine eigenen Körper.
class-refuse-gathered = Alle sehen gerade den Körper der Lehrkraft.
class-refuse-begun = Die Stunde hat begonnen: Ihre Lektion lässt sich nicht mehr wählen.
class-refuse-steps = Eine Stunde hat höchstens { $most } Schritte; diese Szene hat { $steps }.
class-refuse-closed = Die Stunde hat begonnen; bitte deine Lehrkraft, die Tür zu öffnen.
class-refuse-network = Dein Netz hat { $seats } Plätze, mehr bekommt keines; deine Lehrkraft kann welche entfernen.
class-refuse-removed = Die Lehrkraft hat diesen Platz geschlossen.
class-refuse-full = Die Klasse ist voll: Sie hat { $seats } Plätze.
class-refuse-names = In dieser Klasse werden die Namen vergeben.
class-refuse-no-name = Ein Name braucht mindestens einen Buchstaben.
class-refuse-same-name = Diesen Namen hat schon jemand.
class-refuse-digits = Diese Zahl hat gerade kein Platz.
class-refuse-own-answers = Dieses Gerät hat schon einen Platz mit eigenen Antworten.
class-refuse-not-yours = Diese Antwort ist von jemand anderem.
class-refuse-one = Hier sitzt nur eine Person.
class-refuse-no-step = Diesen Schritt hat die Stunde nicht.
class-refuse-not-asked = Danach ist die Klasse nicht gefragt worden.
class-refuse-has-run = Du hast es laufen sehen: Deine erste Antwort zählt.
class-refuse-shown = Die Antworten sind gezeigt worden; deine bleibt, wie sie war.
class-refuse-answers = Ein Platz kann { $most } Antworten abgeben.
class-refuse-no-seat = Diesen Platz gibt es nicht.
class-refuse-no-answer = Diese Antwort gibt es nicht.
class-refuse-no-choice = Diese Antwortmöglichkeit hat die Frage nicht.
class-refuse-no-such-place = Das ist keine Lage für diesen Körper.
class-refuse-no-letter = Ein Satz braucht mindestens einen Buchstaben.
class-at-goal = Ziel erreicht
class-not-at-goal = Ziel nicht erreicht
class-refuse-tries = Das waren zu viele Versuche; lade die Seite neu, um weiterzumachen.
class-refuse-begin = Dieser Schritt kann nicht beginnen: { $reason }.
class-refuse-other-page = Eine andere Seite hat jetzt diesen Platz.
class-refuse-cannot-begin = Dieser Schritt kann nicht beginnen.
class-refuse-no-run = Gerade gibt es keinen Lauf, den du abgeben kannst.
class-refuse-replay = Gerade läuft eine Aufzeichnung; es gibt nichts abzugeben.
class-refuse-code = Eine Klasse { $code } gibt es hier gerade nicht.
seat-try-again = Probiere andere Werte und setze zurück.
class-told-at = { $day }. { $month ->
    [1] Januar
    [2] Februar
    [3] März
    [4] April
    [5] Mai
    [6] Juni
    [7] Juli
    [8] August
    [9] September
    [10] Oktober
    [11] November
   *[12] Dezember
  } um { $time } Uhr

## Die Leinwand: was alle auf dem Projektor sehen.

class-answered = { $done } von { $all } haben geantwortet
class-wrote = { $done } von { $all } haben einen Satz geschrieben
class-handed-in = { $done } von { $all } haben abgegeben
wall-nobody = Noch niemand da? Netze halten Geräte manchmal voneinander fern: Versuchen Sie den Hotspot dieses Rechners.
wall-way-in = { $address } öffnen und { $code } eingeben
wall-scan = Scannen, oder { $address } öffnen und diese Buchstaben eingeben:
wall-here = { $count ->
    [one] { $count } ist da
   *[other] { $count } sind da
  }
wall-step = Schritt { $number } von { $steps }
wall-now = Jetzt: { $runs }
wall-where = Wo wird es { $seconds } s nach dem Start sein?
wall-next = Jetzt: Erklärt euren Nachbarn, warum.
wall-trying = { $count ->
    [one] probiert
   *[other] probieren
  }
wall-exploded = { $count ->
   *[other] explodiert
  }
wall-untouched = { $count ->
   *[other] unberührt
  }
wall-at-goal = { $count ->
   *[other] am Ziel
  }
