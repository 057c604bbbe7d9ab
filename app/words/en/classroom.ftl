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
# What holds these, and what is said when one was moved: $moved as in class-moved.
class-grips = Your prediction
class-moved-mass = Mass { $mass }: { $moved }
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
seat-ask-drag = Move the pale body to where it will be { $seconds } s after the start. Nobody else can see it yet.
seat-ask-both = Move the pale body to where it will be { $seconds } s after the start, and choose an answer. Nobody else can see it yet.
seat-ask-choose = Choose an answer. Nobody else can see it yet.
seat-ask-again = Choose once more. Nobody else can see it yet.
seat-try = Try it: this body is yours.

# Homework, where each step asks first and runs then.
seat-home-drag = Move the pale body to where it will be { $seconds } s after the start. Then it runs.
seat-home-both = Move the pale body to where it will be { $seconds } s after the start and choose an answer. Then it runs.
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
seat-handed-moved = The answers are shown: your prediction was handed in as you had moved it.
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
class-answered = { $done ->
    [one] { $done } of { $all } has answered
   *[other] { $done } of { $all } have answered
  }
class-wrote = { $done ->
    [one] { $done } of { $all } has written a line
   *[other] { $done } of { $all } have written a line
  }
class-handed-in = { $done ->
    [one] { $done } of { $all } has handed in
   *[other] { $done } of { $all } have handed in
  }
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

## The teacher's desk.

# What a screen reader calls its halves.
desk-lead = What to say and do
desk-room = The class
desk-over = The class is over
desk-nothing-kept = Nothing that was given is kept on this computer.

# How many pupils are.
desk-here = { $count } here
desk-wall = Wall
desk-controls = Controls
  .label = Controls of my own body
desk-not-kept = not kept
desk-saving = saving…
desk-pupils-type = Pupils type { $address } and { $code }.
desk-more = More
desk-come-in = How pupils come in

# On buttons: what the class does next.
desk-lobby = Come in
desk-show = Look at me
desk-ask = Ask
  .again = Ask again
desk-results = Show answers
  .again = Show answers again
desk-run = Run it
desk-reveal = Reveal
desk-explain = Explain in a line
desk-try = Let them try
desk-collect = Collect
desk-step = Step { $number }
desk-steps = Step
desk-phase = Phase { $number } of { $phases }
desk-minutes = { $minutes } min so far
desk-say = Say
desk-do = Do
desk-next = Next: { $place }
desk-last = That was the last step.
desk-back = Back
  .label = Back to: { $place }
desk-all-phases = All phases

# What the percentage of right answers suggests; some have not answered.
desk-teach = { $part } % right: teach it once more.
  .some = { $part } % right of the { $votes } who have answered: teach it once more.
desk-pairs = { $part } % right: let them talk in pairs, then ask again.
  .some = { $part } % right of the { $votes } who have answered: let them talk in pairs, then ask again.
desk-on = { $part } % right: go on.
  .some = { $part } % right of the { $votes } who have answered: go on.
desk-replay = Again, slowly
  .now = Slowly, from the start…
desk-gather = All look at mine
desk-pause = Pause all
desk-reset = Reset all
desk-give-mine = Give all mine
  .confirm = Give each one your body as it is now? What they have is gone.
desk-law = Show the law
desk-open = Open the door
desk-close = Close the door
desk-own-names = Let them type names
desk-given-names = Names by us
desk-sheet = Save a sheet to print
desk-zip = Save all as a zip
desk-end = End
  .confirm = End the class? Everything that was given is deleted.

# Homework.
desk-home-until = Homework until { $date }
  .about = Pupils come in at any time, without you. They see the right answers then, or as soon as you tell them.
desk-home-told = Homework: answers told
  .about = Everybody sees the right answers. What comes in now counts as late.
desk-tell = Tell the right answers now
  .confirm = Tell everybody the right answers now? What comes in after that counts as late.
desk-home-step = { $number }. { $title }: { $answered } answered, { $handed } handed in

# What to look at before the class.
desk-lesson = Lesson
desk-which-lesson = Which lesson?
desk-lesson-steps = { $count ->
    [one] It has { $count } step.
   *[other] It has { $count } steps.
  }
desk-address = Address
desk-which-network = In which network are the pupils?
desk-networks = This computer is in several. The addresses of pupils' devices begin alike.
desk-lets-in = Does the network let them in?
desk-scan = Scan this with a phone that is in the pupils' network, or open { $address }
desk-finds-nothing = If a phone finds nothing at this address, the network keeps devices apart: use this computer's own hotspot.

# A device that has checked whether it can take part.
desk-tried-in-vain = A device: it cannot take part; it says why.
desk-tried = A device: all right, { $ms } ms, { $rate } pictures a second
desk-tried-doubts = A device: works, and says what to mind, { $ms } ms, { $rate } pictures a second
desk-projector = Put the wall on the projector
desk-open-wall = Open the wall
desk-way-in = The wall shows this, too, large: it is the pupils' way in.

# Answers that pupils gave in files.
desk-files = Answers from files
desk-from-files = From pupils who had the lesson as a file: they count as late answers, each once.
desk-lesson-file = Save the lesson as a file for them
desk-their-files = Their files
desk-codes = Or the text of their QR codes, from a scanner or pasted
desk-take = Take it
desk-file-too-long = That file is too long for answers to a lesson.
desk-brought = { $name }: { $count ->
    [one] 1 answer
   *[other] { $count } answers
  }.
desk-brought-known = { $name }: { $count ->
    [one] 1 answer
   *[other] { $count } answers
  }, { $known } had been brought before.
desk-brought-goals = { $count ->
    [one] As its own file says, it reached the goal of step { $steps }.
   *[other] As its own file says, it reached the goal of steps { $steps }.
  }

# How many do what; the number stands before it.
desk-count-handed-in = { $count ->
    [one] has handed in
   *[other] have handed in
  }
desk-count-trying = { $count ->
    [one] is trying
   *[other] are trying
  }
desk-count-exploded = { $count ->
    [one] has exploded
   *[other] have exploded
  }
desk-count-idle = { $count ->
    [one] has changed nothing
   *[other] have changed nothing
  }

# The question, and who has chosen what.
desk-chose = What they chose
  .now = What they chose so far
desk-sealed = only you see this
desk-most = { $count } chose “{ $choice }”: ask one of them why.
desk-predicted = { $count } dragged a prediction.
  .some = { $count } of { $all } have dragged a prediction.
desk-found = What they found so far

# Of a seat, and of its body.
desk-who = Who is here
desk-who-away = { $here }; { $away } away
desk-nobody = Nobody yet.
desk-name-two = { $name } (two)
desk-two = two
desk-away = away
desk-follows = looks at yours
desk-done = { $done } of { $steps } steps
desk-moving = moving
desk-untouched = untouched
desk-at-rest = at rest
desk-paused = paused
desk-exploded = exploded
desk-goal-reached = goal reached
desk-on-wall = on the wall
desk-has-predicted = has predicted
desk-has-answered = has answered
desk-hand = hand is up
desk-lower-hands = Lower hands
desk-to-wall = Put on the wall
desk-off-wall = Take off the wall
desk-reset-one = Reset this one
desk-to-all = Back to all
desk-move = Move to another device
desk-move-digits = On the other device: { $digits }
desk-move-how = There, come in, choose “This seat” and type { $digits }.
desk-remove = Remove
  .confirm = Close the seat of { $name }? What it gave goes, too.

# Answers.
desk-work = Handed in: { $count }
desk-lines = Lines: { $count }
desk-predictions = Predictions: { $count }
desk-gave = Gave: { $what }
desk-by = { $name }: { $what }
desk-a-prediction = a prediction
desk-a-run = a run
desk-late = { $what } (late)
desk-doubt = { $what }: { $doubt }
desk-star = Show this line on the wall, by { $name }
desk-show-body = Show the body of { $name } on the wall
desk-show-prediction = Show the prediction of { $name } alone on the wall

# What the teacher is told.
desk-not-possible = That is not possible
desk-cannot-begin = This step cannot begin
desk-no-zip = The zip could not be made
desk-no-file = The lesson's file could not be made
desk-no-sheet = The sheet could not be made
desk-the-run = the run
desk-unkept-title = The class is not being kept
desk-unkept = { $reason }. What pupils give now waits on their pages, and is gone if those are closed. Make room on the disk of the computer that holds the class, or take the zip home now.
desk-kept-title = The class is being kept again
desk-kept = All that was given is on the disk.
desk-goes-on-title = The class goes on
desk-goes-on = Its folder { $folder } cannot be deleted: { $reason }.
class-refuse-no-body = That seat has no body of its own now.
class-refuse-no-replay = There is no run to see again.
class-refuse-replay-broken = The run cannot be seen again: { $reason }.
class-refuse-classes = A server holds { $most } classes at most.
class-refuse-scenes = A class has { $most } steps at most; these scenes have { $steps }.
class-refuse-no-code = That is no code of answers: it begins with SR1 and has letters and digits.
class-refuse-no-file = That file has no answers to a lesson.
class-refuse-misread = The code was read with a wrong letter: scan it again.
class-refuse-other-steps = These answers are to a lesson with another number of steps.
class-refuse-empty = There is no answer in it yet.
class-refuse-other-lesson = These answers are to another lesson than this class's.

# Why a run that was handed in cannot be the pupil's own.
class-doubt-begins = the log begins with { $what }.
class-doubt-goes-on = the log goes on with { $what }.
class-doubt-begins-other = the log begins with another scene than the step's.
class-doubt-goes-on-other = the log goes on with another scene than the step's.
class-doubt-sets = the log sets { $what }, which this step has no slider for.
class-doubt-never = the log goes on from where the body never was; begin anew and hand in that run.
class-doubt-long = the log has more than { $what }.

## The zip that a teacher takes home.

zip-readme = 
    What a class gave: { $steps ->
        [one] 1 step
       *[other] { $steps } steps
      }, { $seats ->
        [one] 1 seat
       *[other] { $seats } seats
      }.

    answers.csv      votes, lines and what was handed in, a row each
    found.csv        what was found and what it was set to, a row a run
    predictions.csv  where masses were predicted to be, in the scene's units, a row a mass
    scenes/          what the class went through; `softrod class scenes/*.json` goes through it with another class
    logs/            the runs that were handed in; `softrod run --inputs FILE` does one again
    pictures/        how the bodies were when they were handed in

    The tables have decimal points, and commas between their columns.

    { $names } When the class is ended, nothing of this is left on the computer that held it.
zip-typed-names = Some seats have names that pupils typed.
zip-given-names = Seats have the names that the class gave out.

# Heads of columns.
zip-step = step
zip-title = title
# Which time in the class this step was asked: 1, 2, …
zip-asked = asked
zip-seat = seat
zip-name = name
zip-pupil = pupil
zip-kind = kind
zip-answer = answer
zip-right = right
zip-late = late
zip-starred = starred
# What the run is plotted over, and the setting that a pupil chose.
zip-over = over
zip-over-unit = over unit
zip-setting = setting
zip-what = what
zip-unit = unit
zip-found = found
zip-doubt = doubt
zip-mass = mass
zip-x = x
zip-y = y

# Cells.
zip-vote = vote
zip-line = line
zip-work = handed in
zip-yes = yes
zip-no = no
