session-not-done = Das geht nicht
session-back = Zurück zu „{ $title }“
    .undo = Rückgängig führt wieder zu „{ $before }“.
    .redo = Wiederholen führt wieder zu „{ $before }“.
session-no-shape = Diese Form kann nicht gehalten werden
    .line = Die Linie zeigt, wohin sich der Körper bewegt.
    .stiffen = Die Taste „Halten, { $times }-mal so steif“ macht ihn so.
