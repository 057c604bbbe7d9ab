class-title = softrod: eine Klasse
class-needs-javascript = Für eine Klasse ist JavaScript nötig; hier ist es ausgeschaltet.
class-blocked = Die Seite ist geladen, aber ihre Verbindung kommt nicht zustande: Etwas auf dem Weg sperrt WebSockets. Versuche ein anderes Netz, etwa den Hotspot des Rechners der Lehrkraft.
