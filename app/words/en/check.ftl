# The page that checks whether a device can take part in a class. "It" is the device, if not the page.

check-title = softrod: can this device take part?
check-heading = Can a device take part from here?
check-looking = Looking: this takes some 4 seconds.
check-came = This page came: the device reaches the teacher's computer.
check-no-script = Its script did not come, or does not run.
  .why = JavaScript may be switched off, a filter may keep scripts out, or the browser may be too old. Try another browser, and then another network: the hotspot of the teacher's computer.

# Verdicts.
check-good = All right: a class works from here.
check-fair = A class works from here; read what is marked.
check-bad = Here a class does not work.
check-again = Try again

# What was found, and what to do about it.
check-hotspot = Use another network: the hotspot of the teacher's computer or of a phone needs no internet.
check-without = Without any connection, a replay plays: one file, which the teacher's page makes under Share.
check-scripts = Its scripts come, in { $ms } ms.
check-no-scripts = The scripts of the class's pages do not come.
check-blocks = Something on the way blocks them.
check-shows = This browser can show a class.
check-too-old = This browser cannot show a class: it is too old.
check-current = Use a current Chrome, Edge, Firefox or Safari.
check-stores = This browser stores answers until they have arrived.
check-stores-not = This browser stores nothing: an answer that has not arrived is lost by a reload.
check-allow = Leave the private window, or allow the page to store data.
check-clock = Its clock agrees with the teacher's.
check-apart = Its clock and the teacher's differ by { $minutes } minutes.
check-https = A class does not mind, but addresses with https may be refused.
check-no-sockets = This browser makes no live connection (WebSocket).
check-connected = A live connection (WebSocket) comes about, after { $ms } ms.
check-cut = The connection was cut after { $ms } ms.
check-ends = Something on the way ends it.
check-blocked = No live connection (WebSocket) comes about, although pages do: something on the way, such as a school's web filter or proxy, lets none through.
check-let-through = Or have whoever runs the network let WebSockets to { $host } through; pages by https often pass where those by http do not.
check-refused = The teacher's computer refuses the connection: { $reason }
check-silent = The teacher's computer no longer answers.
check-awake = Is softrod still running, and the computer awake?
check-no-answer = The connection is there, but no answer comes through it.
check-holds = Something on the way holds messages back.
check-slow = The round trip takes { $ms } ms: bodies follow a finger late.
check-trip = The round trip takes { $ms } ms.
check-nearer = Go nearer to the access point, or use fewer devices at a time.
check-no-pictures = No moving pictures arrive.
check-jerks = Only { $rate } pictures a second arrive: motion jerks.
check-pictures = Moving pictures arrive, { $rate } a second.
