# A pupil's page, the wall and the teacher's desk.

class-title = softrod: a class
class-needs-javascript = A class needs JavaScript, which is switched off here.
class-blocked = The page has loaded, but its live connection fails: something on the way blocks WebSockets. Try another network, such as the hotspot of the teacher's computer.
class-over = The class is over.
class-why = Why? Answer in one sentence.
class-hand-in = Hand in what you found.
class-goal = Goal: { $goal }
class-goal-met = Reached: { $goal }
class-found = What the class found
class-qr-code = QR code of { $address }
# What a screen reader calls the class's plot: what was found over what was set.
class-plot = { $what } over { $over }: { $count ->
    [one] 1 point
   *[other] { $count } points
  }
  .law = { $what } over { $over }: { $count ->
    [one] 1 point
   *[other] { $count } points
  }; { $law }
# Beside the reader's own point of the plot.
class-plot-you = you: { $value }
# Of a disc by which a prediction is dragged.
class-grip = Mass { $mass } of your prediction: move it with the arrow keys
# How far a mass has gone, or was put from where it was.
class-moved =
  .lower = { $length } lower
  .higher = { $length } higher
  .left = { $length } to the left
  .right = { $length } to the right
# Over the dots of all predictions.
class-where-put = where you put it

## A pupil's page.

# What a screen reader calls the card.
seat-region = Class
seat-nothing-kept = Nothing that you gave is kept here.
seat-away-alone = Not connected: your body goes on here, which does not count. Reconnecting…
seat-hand-up = Hand up
seat-hand-is-up = Hand is up
seat-on-page = Another page of this browser has your seat now.
seat-on-device = Another device has your seat now.
seat-come-back = Come back here
seat-who = Who are you? Type your name, so that your teacher knows whose answers these are.
seat-your-name = Your name
seat-name-me = That is me
seat-on-wall = Yours is on the wall now.
seat-follow = Look at the teacher's
seat-own-body = Back to my own body
seat-about = This seat
seat-why = The question, and why
seat-waiting = Not at the teacher's yet: kept here, and sent as soon as that is possible.
seat-letters = The four letters on the wall
seat-come-in = Come in

# What to do now, in one sentence.
seat-is-in = You are in. It begins soon.
seat-look = Look to the front.
seat-teacher-away = Your teacher's page is away for a moment: wait.
seat-gathered = Look to the front: this is your teacher's body. Yours waits.
seat-follows = This is your teacher's body. Yours waits.
seat-paused = Paused: look to the front.
seat-can-change = You can still change it. Nobody else can see it yet.
seat-ask-drag = Drag the pale body to where it will be { $seconds } s after the start. Nobody else can see it yet.
seat-ask-both = Drag the pale body to where it will be { $seconds } s after the start, and choose an answer. Nobody else can see it yet.
seat-ask-choose = Choose an answer. Nobody else can see it yet.
seat-ask-again = Choose once more. Nobody else can see it yet.
seat-try = Try it: this body is yours.

# Homework, where each step asks first and runs then.
seat-home-drag = Drag the pale body to where it will be { $seconds } s after the start. Then it runs.
seat-home-both = Drag the pale body to where it will be { $seconds } s after the start and choose an answer. Then it runs.
seat-home-choose = Choose an answer. Then it runs.
seat-late-now = What you give now counts as late.
seat-home-own = Now it is your turn: this body is yours.
seat-step = Step { $number }
seat-step-done = Step { $number }, done
seat-next-step = Next: step { $number } of { $steps }
seat-to-do = { $count ->
    [one] Still to do: step { $steps }.
   *[other] Still to do: steps { $steps }.
  }
seat-all-done = All steps are done. You can close this page.
seat-told-on = You will see the right answer on { $date }.

# Before what to watch for.
seat-watch = Watch:
seat-chose-before = Before you chose: { $choice }
seat-chose = { $late ->
    [yes] You chose: { $choice } (late: after the answers were told).
   *[no] You chose: { $choice }.
  }
seat-right = The right answer: { $choice }.

# The button that hands in a prediction: of a body whose place can be said with that, as in "87.2 px lower".
seat-predict = It will be there
  .place = Hand in { $place }
seat-predicted = Your prediction is in
  .place = Your prediction is in: { $place }
# Buttons that move it.
seat-step-left = A little to the left
seat-step-right = A little to the right
seat-step-up = A little up
seat-step-down = A little down

# Before a line in which the sentence goes on.
seat-because = Because
seat-send = Send
seat-change = Change it
seat-sent = Sent ✓
seat-pause = Pause
seat-play = Play
seat-reset = Reset
seat-slow = At a quarter of the speed
# What would be handed in now, as in "period of mass 1: 1.2 s".
seat-reading = { $what }: { $reading }
seat-no-reading = Nothing to read yet: let it move for a while.
seat-hand-in = Hand in { $reading }
  .instead = Hand in { $reading } instead
seat-hand-in-it = Hand in it
  .instead = Hand in it instead
seat-hand-in-run = Hand in this run
  .instead = Hand in this run instead
seat-handed = { $late ->
    [yes] Handed in (late: after the answers were told).
   *[no] Handed in.
  }
  .text = { $late ->
    [yes] Handed in: { $text } (late: after the answers were told).
   *[no] Handed in: { $text }.
  }

# Of two pupils at one page.
seat-first = First of you
seat-second = Second of you
seat-another-name = Another name
seat-two = We are two
seat-move = Go on with another device
seat-move-digits = On the other device type { $digits }
seat-had = I had a seat on another device: its two digits
seat-take-over = Take it over

## What a teacher says to the class in each phase, and (.do) does.

guide-lobby = Open the address on the wall, and type the four letters.
  .do = Put the wall on the projector. Go on when all are here.
guide-show = Look at the body: what holds it, and what pulls it?
  .before = Point at the parts. Do not press Play yet: it runs after the question.
  .do = Point at the parts. Press Play to let it go: what the question asks about comes later.
guide-drag = Drag the pale body to where it will be { $seconds } s after the start.
# To do, while pupils answer.
guide-ask = Wait until everybody has answered. Do not say which is right.
guide-again = Convince your neighbour, for a minute. Then answer again.
  .do = Listen. Do not say which is right.
guide-results = Who would like to say why they chose what they chose?
  .do = Hear two who answered differently. Do not give the right answer yet.
guide-changed = Who has changed their mind, and why?
  .do = Do not give the right answer yet: the run will show it.
guide-run = Watch what it does.
  .do = Let it run until everybody has seen what happens.
guide-run-new = Watch what it does. This is new: { $runs }
# To do.
guide-run-stops = It stops at { $seconds } s. Compare it with the predictions.
guide-reveal = That is the answer. Tell your neighbour why.
  .predicted = The wall shows the predictions beside the body, then the right answer. Give it a moment before you speak.
  .do = The wall shows the right answer. Give it a moment before you speak.
# To do.
guide-explain = Star two answers: they go on the wall in the next phase. Then explain it in your own words: { $because }
guide-try = Walk around. Raised hands show at the right.
guide-collect = Hand in the { $collects }.
# To do.
guide-plot = When most have, look at the class's plot together: what does it say? Press Show the law, if it is offered.
guide-collected = When most have, put one of them on the wall.

## What the server says to a page of a class.

# Why something that a page asked for is refused.
class-refuse-together = The class goes on together.
class-refuse-no-home-step = The homework has no such step.
class-refuse-no-place = The class has no such place.
class-refuse-sealed = Nobody sees the answers before all are shown.
class-refuse-no-bodies = Seats have no bodies of their own now.
class-refuse-gathered = All look at the teacher's now.
class-refuse-begun = The class has begun: its lesson can no longer be chosen.
class-refuse-steps = A class has { $most } steps at most; this scene has { $steps }.
class-refuse-closed = The class has begun; ask your teacher to open the door.
class-refuse-network = Your network has { $seats } seats, as many as one gets; your teacher can remove some.
class-refuse-removed = The teacher has closed this seat.
class-refuse-full = The class is full: it has { $seats } seats.
class-refuse-names = In this class names are given.
class-refuse-no-name = A name needs a letter.
class-refuse-same-name = Somebody has that name.
class-refuse-digits = No seat has that number now.
class-refuse-own-answers = This device has a seat with answers of its own.
class-refuse-not-yours = That answer is somebody else's.
class-refuse-one = Only one sits here.
class-refuse-no-step = The class has no such step.
class-refuse-not-asked = The class has not been asked for that.
class-refuse-has-run = You have seen it run: your first answer counts.
class-refuse-shown = The answers have been shown; yours stays as it was.
class-refuse-answers = A seat can give { $most } answers.
class-refuse-no-seat = There is no such seat.
class-refuse-no-answer = There is no such answer.
class-refuse-no-choice = The question has no such choice.
class-refuse-no-such-place = That is no place for this body.
class-refuse-no-letter = A line needs a letter.
# Of a run that was handed in.
class-at-goal = goal reached
class-not-at-goal = goal not reached
class-refuse-tries = These were too many tries; reload the page to go on.
class-refuse-begin = This step cannot begin: { $reason }.
class-refuse-other-page = Another page has this seat now.
class-refuse-cannot-begin = This step cannot begin.
class-refuse-no-run = There is no run to hand in now.
class-refuse-replay = A log is being played; there is nothing to hand in.
class-refuse-code = There is no class { $code } here now.
# To a pupil whose body has exploded.
seat-try-again = Try other values, and press Reset.
# When what is right in homework is told.
class-told-at = { $day } { $month ->
    [1] January
    [2] February
    [3] March
    [4] April
    [5] May
    [6] June
    [7] July
    [8] August
    [9] September
    [10] October
    [11] November
   *[12] December
  }, { $time }

## The wall: what all see on the projector.

# Also on the teacher's desk.
class-answered = { $done } of { $all } have answered
class-wrote = { $done } of { $all } have written a line
class-handed-in = { $done } of { $all } have handed in
wall-nobody = Nobody yet? Networks may keep devices apart: try this laptop's hotspot.
wall-way-in = Open { $address } and type { $code }
# The code stands below, large.
wall-scan = Scan this, or open { $address } and type
wall-here = { $count ->
    [one] { $count } is here
   *[other] { $count } are here
  }
wall-step = Step { $number } of { $steps }
# Before what is otherwise when it runs.
wall-now = Now: { $runs }
wall-where = Where will it be { $seconds } s after the start?
wall-next = Next: tell your neighbour why.
# How many bodies do what: the number stands over it, large.
wall-trying = { $count ->
   *[other] trying
  }
wall-exploded = { $count ->
   *[other] exploded
  }
wall-untouched = { $count ->
   *[other] untouched
  }
wall-at-goal = { $count ->
   *[other] at the goal
  }
