stage-away = Der Körper ist nicht zu sehen. Die ganze Szene zeigen
stage-drag = zieh mich
stage-empty = Hier ist noch nichts gebaut.
    .draw = Einen Körper zeichnen
    .tap = Tippe für eine Masse. Ziehe von einer Masse aus für eine Feder.
    .click = Klicke für eine Masse. Ziehe von einer Masse aus für eine Feder.
    .taps = Tippe für eine Masse. Tippe auf eine Masse und dann auf eine andere für eine Feder.
